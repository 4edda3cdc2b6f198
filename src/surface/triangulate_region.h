#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A closed polyline: vertices by index, the last joined to the first.
using Loop = std::vector<std::uint32_t>;

/// Twice the signed area, counter-clockwise positive.
[[nodiscard]] double twice_area(const Loop& loop, std::span<const Vec2> points);

/// Is p inside (nonzero winding)? Of points on the loop some are and some are not.
[[nodiscard]] bool is_inside(const Loop& loop, std::span<const Vec2> points, Vec2 p);

/// Triangles of the region inside `outer` and outside `holes`, wound as `outer` is. No vertex is added: every
/// edge of a loop belongs to exactly one triangle, run through as `outer` runs, holes against that.
///
/// Holes are joined to the outer loop by bridges, and ears are cut off what results (Meisters 1975; Eberly,
/// Triangulation by Ear Clipping). Loops that cross or touch still give as many triangles, some of them
/// folded over.
/// holes: wound against `outer`.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate_region(const Loop& outer,
                                                                           std::vector<Loop> holes,
                                                                           std::span<const Vec2> points);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
