#pragma once

#include "tandem/shape/cubic_path.h"
#include "tandem/shape/intersections.h"

namespace tandem {
inline namespace v0 {

/// Moves a crossing found on polylines onto the curves, by Newton's method, where that converges next to it;
/// leaves it as it is elsewhere (curves that run along each other, cusps).
void refine_crossing(Crossing& crossing, const CubicPath& path_a, const CubicPath& path_b);

}  // namespace v0
}  // namespace tandem
