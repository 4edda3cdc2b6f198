#pragma once

#include "tandem/surface/mesh.h"
#include "tandem/surface/surface.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// What becomes of vertices at one place that differ in normal or parameters: at creases (knots where the
/// surface is C0 only), at the seam of a closed parameter, and where an edge is a point.
enum class Joints {
  /// One vertex, with the mean normal: the mesh is watertight where the surface is closed.
  welded,
  /// One for each normal and each pair of parameters, for shading and textures; their positions are equal.
  split
};

struct TessellateOptions {
  double chord = 1e-3;  ///< largest distance of mesh and surface, as a share of the surface's extent; > 0
  /// Largest angle between a triangle and the surface at its corners, in radians; > 0. It is not asked of
  /// triangles that are no higher than the chord distance, or than a thousandth of the extent, nor of grids
  /// of more than 2^18 cells: cusps and folds never reach it.
  double angle = 0.15;
  Joints joints = Joints::welded;
};

/// The surface as triangles with its exact normals: a grid of parameter lines, denser where the surface asks
/// for it, without T-junctions and without triangles of no area, counter-clockwise seen from S_u x S_v.
/// Edges that meet share their vertices (Surface::is_closed); those that are a point have one. Planar
/// surfaces lie in z = 0. Deviations are measured at samples, several in each cell.
/// @throws InvalidArgument a surface of another dimension than 2 and 3; chord or angle not above 0; more than
/// 2^22 vertices would be needed; a chord distance that doubles do not resolve as far from the origin
[[nodiscard]] TANDEM_EXPORT TriangleMesh tessellate(const Surface& surface,
                                                    const TessellateOptions& options = {});

}  // namespace v0
}  // namespace tandem
