#pragma once

#include <cstddef>
#include <span>

#include "tandem/curve/curve.h"
#include "tandem/curve/points.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Splines through lines of numbers, one per section, at increasing v: lines are points of a large space.

/// Mean distance of points of the same index, without overflow.
[[nodiscard]] double mean_distance(const Points& a, const Points& b);

/// As many control points as rows; knots are averages of v. The NURBS Book, eqs. (9.5), (9.8). The ends are
/// exact.
[[nodiscard]] Curve interpolate_rows(const Points& rows, std::span<const double> v, int degree);

/// Periodic, of period 1; clamped over [0, 1].
[[nodiscard]] Curve interpolate_loop(const Points& rows, std::span<const double> v, int degree);

/// Least squares with `n` control points, the ends exact. The NURBS Book, eqs. (9.63) - (9.69).
[[nodiscard]] Curve approximate_rows(const Points& rows, std::span<const double> v, int degree,
                                     std::size_t n);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
