#pragma once

#include <array>
#include <optional>

#include "surface/boundary.h"
#include "surface/boundary_arc.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The chords of two pieces cross, and the pieces are about straight: worth a proof. In plain arithmetic.
[[nodiscard]] bool seem_to_cross(const BoundaryArc& a, const BoundaryArc& b);

/// Two places of the boundary with the same point, near where the chords of a and b cross; proved to exist,
/// and known to some digits less than double has.
///
/// Proof: like a road and a river. If f(p) = p n for some direction n is smaller at the start of arc X than
/// anywhere on arc Y and larger at its end, and g(p) = p m is so for Y and X, then X(s) = Y(t) for some s and
/// t (Poincare-Miranda on f(X(s)) - f(Y(t)) and g(X(s)) - g(Y(t))).
[[nodiscard]] std::optional<std::array<BoundaryPlace, 2>> prove_crossing(const BoundaryArc& a,
                                                                         const BoundaryArc& b);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
