#pragma once

#include <span>
#include <vector>

#include "match/path_correspondence.h"
#include "match/sample_pair.h"
#include "match/search.h"
#include "tandem/match/segments.h"
#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Two curves as the segments method sees them.
struct SegmentPaths {
  CubicPath a;
  CubicPath b;
  std::vector<double> breaks_a;  ///< the curves' parameters at the joints
  std::vector<double> breaks_b;
  std::vector<ParameterPair> pins;  ///< joints of the paths
  SamplePair samples;               ///< at the joints
};

/// pins: settled, in the curves' own parameters; the paths get joints there.
[[nodiscard]] SegmentPaths segment_paths(const Curve& a, const Curve& b, Layout layout,
                                         std::span<const ParameterPair> pins);

/// The optimum, with b turned back by the rotation of the options.
[[nodiscard]] SegmentMatch match_segment_paths(const SegmentPaths& paths, const MatchOptions& options);

/// The match in the curves' own parameters; all of its points are corners, so that the fit passes through
/// them.
[[nodiscard]] PathParameters path_parameters(const SegmentMatch& match, const SegmentPaths& paths);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
