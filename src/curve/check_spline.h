#pragma once

#include <vector>

#include "tandem/curve/points.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// What a spline in one or two parameters is made of. All throw InvalidArgument.

/// Finite, non-decreasing, a domain that is not empty, interior multiplicities up to the degree, those at the
/// ends up to one more. There are enough for at least degree + 1 control points.
void check_knots(int degree, const std::vector<double>& knots);
/// Finite, up to 1e304 in size.
void check_points(const Points& points);
/// Within [1e-100, 1e100].
void check_weights(const std::vector<double>& weights);

/// Diagonal of the points' bounding box, without overflow; 0 for a point.
[[nodiscard]] double box_diagonal(const Points& points);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
