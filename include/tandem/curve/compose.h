#pragma once

#include "tandem/curve/curve.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// outer(inner(u)), exact: degree p * q, polynomial or rational, over the domain of `inner`.
///
/// `inner` is a scalar spline (dim 1), strictly increasing, whose values lie in the domain of `outer` (values
/// beyond its ends by no more than rounding are clamped). Knots of the result: those of `inner` and the
/// inverse images of `outer`'s, with the multiplicities that the continuity of both allows. A breakpoint of
/// `inner` whose value is a knot of `outer` (within 1e-12 of the domain) stays where it is.
///
/// Error: the result is within 1e-12 of the size of `outer`, piecewise, for p * q <= 12 and weights in
/// [0.1, 10]; within 1e-10 beyond (spec C8). Where `outer` is fast, the rounding of the result's own knots
/// adds the speed times half an ulp of the parameter: the point slides along the curve by that much.
///
/// Source: [C] appendix A, eqs. (8)-(10), here by blossoming with Bernstein products, which only forms convex
/// combinations; DeRose, Composing Bezier Simplexes (1988).
/// @throws InvalidArgument inner is not scalar, not increasing, or leaves the domain of outer
[[nodiscard]] TANDEM_EXPORT Curve compose(const Curve& outer, const Curve& inner);

}  // namespace v0
}  // namespace tandem
