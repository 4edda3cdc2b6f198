#pragma once

#include "surface/findings.h"
#include "tandem/surface/surface.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Whether S_u x S_v is nowhere zero on a surface in R^3: proved on a cell by a direction n such that
/// n (S_u x S_v), a polynomial whose Bernstein coefficients are known, is positive; cells without one are
/// halved.
[[nodiscard]] Findings examine_in_space(const Surface& surface);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
