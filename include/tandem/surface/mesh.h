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

}  // namespace v0
}  // namespace tandem
