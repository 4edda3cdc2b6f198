#pragma once

#include <vector>

#include "tandem/curve/arc_length.h"
#include "tandem/curve/curve.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A node as it is placed: where on the curve, and how long the chord to the next node is.
struct PlacedNode {
  double parameter = 0.0;
  double chord = 0.0;  ///< arc length to the next node (unused for the last node of an open curve)
};

/// Nodes nearly uniform in arc length (or in length and turning), one at every corner. On a cyclic curve all
/// parameters lie in [lo, hi) and do not depend on the seam.
/// corners: parameters of the corners, increasing, inside the domain (cyclic: lo stands for the seam).
[[nodiscard]] std::vector<PlacedNode> place_by_length(const Curve& curve, const ArcLength& arc,
                                                      const std::vector<double>& corners,
                                                      const SampleOptions& options);

/// Parameters of knots at which the tangent turns by more than `angle`; at most `most` of them, the sharpest.
/// cyclic: the seam counts as a knot (reported as lo).
[[nodiscard]] std::vector<double> find_corners(const Curve& curve, double angle, bool cyclic, int most);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
