#pragma once

#include <span>
#include <vector>

#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {

/// Control points (3k + 1 per curve) of cubics that follow the curves, all with the same breaks. The curves
/// share their degree and knots (see make_compatible).
///
/// Exact for polynomial curves of degree <= 3. Others by Hermite interpolation in the parameter, spans halved
/// until every curve is met within `tolerance` (absolute). Hermite interpolation is linear: blending the
/// cubics of two curves is the same as taking the cubics of their blend.
[[nodiscard]] std::vector<Points> cubic_control_points(std::span<const Curve> curves, double tolerance);

/// The parameters of the curve at which the segments of to_cubic_path(curve, tolerance) begin, and its end.
[[nodiscard]] std::vector<double> cubic_breaks(const Curve& curve, double tolerance);

}  // namespace v0
}  // namespace tandem
