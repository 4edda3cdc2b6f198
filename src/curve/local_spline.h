#pragma once

#include <cstddef>
#include <span>

#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A spline on one span of its knots, as its evaluators see it. `knot` points at the knot that the span
/// starts with; t lies in the span.

/// Degrees up to this one are evaluated without allocating.
inline constexpr std::size_t kStackDegree = 31;

/// The span that t, within the domain, lies in: at a knot the one on that side, as far as there is one.
[[nodiscard]] std::size_t span_on_side(std::span<const double> knots, int degree, double t,
                                       Side side) noexcept;

/// The degree + 1 B-splines that live on the span; and, if `slopes` is given, the `degree` B-splines of one
/// degree less, each divided by the length of its support: what the derivative multiplies differences of
/// control points with. Source: The NURBS Book, A2.2, as convex combinations.
void basis(const double* knot, int degree, double t, double* value, double* slopes);

/// Derivatives 0 .. order into rows, `stride` numbers each; zero above the degree.
/// local: the degree + 1 coefficients of the span, `stride` numbers each; they are overwritten.
void local_derivatives(const double* knot, int degree, double t, int order, std::size_t stride, double* local,
                       double* rows);

/// x, cut off at the largest double; 0 for NaN, which is what too large numbers cancel to.
[[nodiscard]] double saturated(double x);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
