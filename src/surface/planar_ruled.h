#pragma once

#include "surface/findings.h"
#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// What can be proved of the ruled surface (1 - v) a(u) + v b(u), v in [0,1], of two curves in R^2.
[[nodiscard]] Findings examine_planar_ruled(const Curve& a, const Curve& b);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
