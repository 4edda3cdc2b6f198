#pragma once

#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/surface/ruled.h"
#include "tandem/surface/surface.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Angles of the rulings from a(u) to b(u); no crease.
[[nodiscard]] RulingReport measure_rulings(const Curve& a, const Curve& b);

struct Crease {
  double angle = 0.0;
  double u = 0.0;
};
/// Largest jump of the normal across a line of constant u, over the v domain. Looked for at knots where the
/// surface may have one (of full multiplicity), and at the seam of a surface closed along u; not at
/// `corners`. 0 unless in R^3.
[[nodiscard]] Crease find_crease(const Surface& surface, std::span<const double> corners);

/// Curves of the plane over one domain: the share of the area between them, |Jacobian| over u and v, where
/// the Jacobian of the ruled surface has the sign of the smaller part. Linear along each ruling, which is
/// integrated exactly; sampled along u, finely near changes of sign.
[[nodiscard]] double wrong_sign_share(const Curve& a, const Curve& b);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
