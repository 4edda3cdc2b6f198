#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tandem {
inline namespace v0 {
namespace detail {

/// Indices of a polyline's vertices, first and last included, such that the polyline through these alone
/// stays within [low[i], high[i]] at every x[i]; the fewest there are.
///
/// x increasing; low[i] <= y[i] <= high[i]. O(n^2) at worst, O(n) for a straight line.
/// Source: Imai and Iri, Polygonal approximations of a curve (1988), the shortest path over all admissible
/// chords; what a vertex sees is found with the cone of slopes that meet every window so far.
[[nodiscard]] std::vector<std::size_t> fewest_vertices(std::span<const double> x, std::span<const double> y,
                                                       std::span<const double> low,
                                                       std::span<const double> high);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
