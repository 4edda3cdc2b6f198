#pragma once

#include <vector>

#include "tandem/match/correspondence.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/cut_at.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// Lengths are shares of the length of the path they are measured on.
struct AlignOptions {
  /// A joint of the first path and one of the second that are this near to each other along the
  /// correspondence become one.
  double snap = 0.03;
  /// Between two joints the paths run in step by their own parameters; where that strays further than this
  /// from the correspondence, a joint is added.
  double stray = 0.04;
  /// Points of the correspondence that become joints, in the paths' own parameters.
  std::vector<ParameterPair> pins = {};
};

/// Two paths redrawn with the same number of segments, pieces of their own segments: blending them is
/// point by point.
struct AlignedPaths {
  CubicPath a;
  CubicPath b;
  /// Where the first path was cut: parameters of to_curve(a), ascending, first and last the ends (of a closed
  /// path: one lap apart).
  std::vector<double> cuts;
  /// The same of the second path; descending where it is run through backwards.
  std::vector<double> cuts_b;
};

/// Redraws two paths in step with their correspondence, whose parameters are those of to_curve(): the i-th
/// segment over [i, i + 1].
///
/// The joints are those of both paths, each carried over to the other one, except where two nearly coincide
/// (AlignOptions::snap). Every piece lies within one segment of each path, so that the paths do not change.
/// A closed path that the correspondence cuts becomes open.
/// @throws InvalidArgument the dimensions differ, or the correspondence has other domains
[[nodiscard]] TANDEM_EXPORT AlignedPaths align(const CubicPath& a, const CubicPath& b,
                                               const Correspondence& correspondence,
                                               const AlignOptions& options = {});

/// Redraws two paths by nothing but the points of their correspondence: with one of match_segments(), the
/// number of segments is its own (spec D6).
/// @throws InvalidArgument as align(); a piece reaches over a joint of its path
[[nodiscard]] TANDEM_EXPORT AlignedPaths cut_in_step(const CubicPath& a, const CubicPath& b,
                                                     const Correspondence& correspondence);

}  // namespace v0
}  // namespace tandem
