#pragma once

#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// The curves in one function space: common degree, common clamped knot vector, common domain (the first
/// curve's), geometry unchanged. Knots closer than 1e-10 of the domain count as one. All rational or none: if
/// one is rational the others get weights 1; the weights still differ (see with_common_denominator).
/// Source: [C] after eq. (1).
/// @throws InvalidArgument none given, or the dimensions differ
[[nodiscard]] TANDEM_EXPORT std::vector<Curve> make_compatible(std::span<const Curve> curves);

/// make_compatible, and then every curve over the product of all weight functions, so that all have the same
/// weights and blending control points blends Euclidean points (spec C2). Polynomial curves, and rational
/// ones whose weights agree already, keep their degree; otherwise degrees add up (p1 + p2 for two curves).
[[nodiscard]] TANDEM_EXPORT std::vector<Curve> with_common_denominator(std::span<const Curve> curves);

}  // namespace v0
}  // namespace tandem
