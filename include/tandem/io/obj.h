#pragma once

#include <string>

#include "tandem/surface/mesh.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// Wavefront OBJ: vertices, normals and parameters (as texture coordinates, scaled to [0,1]) as far as there
/// are any, and triangles. Coordinates read back equal.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_obj(const TriangleMesh& mesh);

}  // namespace v0
}  // namespace tandem
