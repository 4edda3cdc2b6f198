#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "surface/orientation.h"

namespace tandem {
inline namespace v0 {
namespace detail {

using Triangle = std::array<std::uint32_t, 3>;

/// Whether three points are in a line, exactly.
[[nodiscard]] bool is_flat(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) noexcept;

/// Whether two triangles have a point in common besides the corners, and the edge between them, that they
/// share. Exact, closed triangles; corners are told by index, equal points having equal ones; neither
/// triangle is flat.
[[nodiscard]] bool do_meet(std::span<const SpacePoint> points, const Triangle& s, const Triangle& t) noexcept;

}  // namespace detail
}  // namespace v0
}  // namespace tandem
