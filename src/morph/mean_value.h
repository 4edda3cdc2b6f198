#pragma once

#include "tandem/shape/cubic_path.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Where a point goes when the closed path `from` becomes `to`, which has the same segments: its mean value
/// coordinates in polygons through both (Floater 2003; Hormann and Floater 2006: for points outside as well).
[[nodiscard]] Vec2 carried_along(Vec2 point, const CubicPath& from, const CubicPath& to);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
