#pragma once

#include "surface/findings.h"
#include "tandem/surface/surface.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// What can be proved of any surface in R^2: its Jacobian by Bernstein coefficients and halving, its boundary
/// as find_simple() does. Closed surfaces are those that are closed along u.
[[nodiscard]] Findings examine_planar_patches(const Surface& surface);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
