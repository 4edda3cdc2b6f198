#pragma once

#include <span>

#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {

/// The mean over the length of all curves, of polygons through points on them: what is turned with the curves
/// is turned with it. One dimension; points among the curves do not count, unless there is nothing else.
[[nodiscard]] Point length_center(std::span<const Curve> curves);

}  // namespace v0
}  // namespace tandem
