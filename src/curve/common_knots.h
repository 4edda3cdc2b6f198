#pragma once

#include <span>
#include <vector>

#include "curve/spline.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The curves, clamped, over the first one's domain; all premultiplied when `any_rational`.
/// @throws InvalidArgument none given, or the dimensions differ
[[nodiscard]] std::vector<Spline> over_one_domain(std::span<const Curve> curves, bool any_rational);

/// Makes interior knots of different splines over one domain that nearly agree equal (to that of the first).
void snap_knots(std::span<Spline> splines);

/// Every knot as often as in the spline that has it most often.
[[nodiscard]] std::vector<double> united_knots(std::span<const Spline> splines);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
