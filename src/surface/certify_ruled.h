#pragma once

#include "surface/planar.h"
#include "tandem/curve/curve.h"
#include "tandem/surface/certificate.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Certifies the planar ruled surface between two curves; v is 0 on a and 1 on b, and the points of witnesses
/// are those of the curves.
[[nodiscard]] Certificate certify_planar_ruled(const Curve& a, const Curve& b, const PlaneAxes& axes);

/// From the parts: certified if all are, violated if one is.
[[nodiscard]] Verdict overall(const Certificate& certificate) noexcept;

}  // namespace detail
}  // namespace v0
}  // namespace tandem
