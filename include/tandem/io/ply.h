#pragma once

#include <string>

#include "tandem/surface/mesh.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// PLY 1.0, binary, lowest byte first: vertices as doubles, which read back equal, normals (if there are any)
/// as floats, triangles as lists of three indices.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_ply(const TriangleMesh& mesh);

}  // namespace v0
}  // namespace tandem
