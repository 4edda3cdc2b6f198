#pragma once

#include <array>
#include <cstddef>

#include "tandem/surface/certificate.h"
#include "tandem/surface/mesh.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// Whether a mesh meets itself.
struct SimpleMesh {
  /// Undecided if a triangle's corners are in a line without being two points only, or if coordinates that
  /// are not zero differ in size by more than 1e180.
  Verdict verdict = Verdict::undecided;
  /// When violated: two triangles that meet, by index.
  std::array<std::size_t, 2> triangles{};
};

/// Finds whether two triangles have a point in common besides corners and edges that they share, which are
/// told by place, not by index: seams need not be sewn. Triangles with two equal corners (at poles) do not
/// count. Exact for the doubles given. O(n log n) for ordinary meshes.
/// @throws InvalidArgument a triangle has a corner that does not exist, or vertices are not in R^3 or not
///         finite
[[nodiscard]] TANDEM_EXPORT SimpleMesh find_simple(const TriangleMesh& mesh);

}  // namespace v0
}  // namespace tandem
