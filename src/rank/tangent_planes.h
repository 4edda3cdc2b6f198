#pragma once

#include "match/fixed_costs.h"
#include "tandem/curve/points.h"
#include "tandem/match/rotation.h"

namespace tandem {
inline namespace v0 {
namespace detail {

[[nodiscard]] TangentPlanes to_planes(const Points& tangents);

/// R x for every tangent x.
[[nodiscard]] TangentPlanes turned(const TangentPlanes& tangents, const Rotation& rotation);

/// The rotation `first`, then `second`.
[[nodiscard]] Rotation product(const Rotation& second, const Rotation& first);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
