#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/contour_rings.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A ring cut into pieces along chords, whose ends have become vertices of it.
struct CutRing {
  std::vector<Loop> pieces;              ///< one per partner
  std::vector<std::uint32_t> on_chords;  ///< vertices of the chords, their ends too
};

/// Cuts ring `ring` of a level between its partners on one side, in their shares and places. No pieces where
/// there is no such cut. longest_edge: of chords, in the stack's units.
[[nodiscard]] CutRing cut_ring(std::vector<Ring>& level, std::size_t ring, std::span<const Loop> partners,
                               StackVertices& vertices, double longest_edge);

/// The loop with those of `candidates` that lie on its edges as vertices.
[[nodiscard]] Loop with_vertices_on_edges(const Loop& loop, std::span<const std::uint32_t> candidates,
                                          std::span<const Vec2> places);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
