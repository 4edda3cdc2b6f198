#pragma once

#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/surface/mesh.h"
#include "tandem/surface/surface.h"
#include "tandem/surface/tessellate.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// What a picture of a surface shows: triangles, and lines on them. All in space (3 x n), z up; planar ones in
/// z = 0, y down, as in SVG.
struct Scene {
  TriangleMesh mesh;
  std::vector<Points> iso_lines;  ///< thin: along u, and along v
  std::vector<Points> edges;      ///< where the surface ends
  std::vector<Points> curves;     ///< bold: what the surface was made of
  bool planar = false;            ///< seen from above; triangles that look the other way than most are folds
};

/// The surface with some iso-lines, spread evenly over the domain, more of them where it is longer.
/// curves: drawn boldly; of R^2 or R^3. @throws InvalidArgument as tessellate(); a curve of another dimension
[[nodiscard]] TANDEM_IO_EXPORT Scene scene_of(const Surface& surface, std::span<const Curve> curves = {},
                                              TessellateOptions options = {.chord = 2e-3, .angle = 0.1});

/// A mesh, with its boundary as edges.
[[nodiscard]] TANDEM_IO_EXPORT Scene scene_of(TriangleMesh mesh, std::span<const Curve> curves = {});

}  // namespace v0
}  // namespace tandem
