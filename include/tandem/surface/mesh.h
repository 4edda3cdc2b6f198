#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tandem/curve/points.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// Triangles in space that share vertices. Plain data: who fills it sees to it that the indices exist.
struct TriangleMesh {
  Points vertices;    ///< 3 x n
  Points normals;     ///< 3 x n, unit; or empty
  Points parameters;  ///< 2 x n, (u, v) of the surface; or empty
  /// Vertices of each triangle, counter-clockwise seen from where its normal points.
  std::vector<std::array<std::uint32_t, 3>> triangles;

  friend bool operator==(const TriangleMesh&, const TriangleMesh&) = default;
};

/// The directed edges (from, to) of triangles that have no partner: an edge is matched when it is run through
/// as often backwards as forwards.
[[nodiscard]] TANDEM_EXPORT std::vector<std::array<std::uint32_t, 2>> boundary_edges(
    const TriangleMesh& mesh);

/// Every edge has two triangles, which run through it in opposite directions: a closed, consistently oriented
/// surface. Vertices count by their index, not by their place. False without triangles.
[[nodiscard]] TANDEM_EXPORT bool is_watertight(const TriangleMesh& mesh);

/// Sum of the areas of the triangles.
[[nodiscard]] TANDEM_EXPORT double area(const TriangleMesh& mesh);

/// Enclosed volume of a watertight mesh, positive when its normals point outwards.
[[nodiscard]] TANDEM_EXPORT double volume(const TriangleMesh& mesh);

/// The normal of a triangle by its vertices, unit; zero when it has no area.
[[nodiscard]] TANDEM_EXPORT std::array<double, 3> facet_normal(const TriangleMesh& mesh,
                                                               const std::array<std::uint32_t, 3>& triangle);

}  // namespace v0
}  // namespace tandem
