#pragma once

#include <span>
#include <vector>

#include "tandem/match/segments.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The better direction of two matched paths.
struct FoundSegments {
  std::vector<Node> path;  ///< as SegmentMatch::path
  double cost = 0.0;
  bool reversed = false;
  bool cancelled = false;
};

/// Whether a path is matched as a loop.
struct Loops {
  bool a = false;
  bool b = false;
};

/// Runs the programme in every direction that the options allow. What comes out depends on the curves alone,
/// not on which is the first one or where a loop starts: both are put into an order of their own before.
/// pins: joints of a and of b (forward) that the path must meet at, in place of those of the options.
/// @throws InvalidArgument there is no path: the runs are too short, or the pins cross
[[nodiscard]] FoundSegments search_segments(const CubicPath& a, const CubicPath& b, Loops loops,
                                            std::span<const Node> pins, const SegmentOptions& options);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
