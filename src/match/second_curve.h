#pragma once

#include "tandem/curve/curve.h"
#include "tandem/match/correspondence.h"
#include "tandem/match/reparametrization.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The fit turns v round in the correspondence's domain `cut`; v is to refer to the reversed second curve in
/// its `own`, which differs when a loop was cut.
[[nodiscard]] Reparametrization in_own_domain(Reparametrization r, const Interval& cut, const Interval& own);

/// The second curve as v(u), of in_own_domain(), refers to it: cut, turned round, and with its seam where v
/// begins. compose() it with v.
[[nodiscard]] Curve second_curve(const Curve& b, const Correspondence& correspondence,
                                 const Reparametrization& r);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
