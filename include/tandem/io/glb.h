#pragma once

#include <string>

#include "tandem/surface/mesh.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// glTF 2.0 in one binary file: one mesh with positions, normals and texture coordinates (the parameters,
/// scaled to [0,1]) as floats of 32 bits, as far as there are any, seen from both sides. In glTF y is up; a
/// node turns the mesh, whose z is up. @throws InvalidArgument no triangle; a coordinate does not fit, or the
/// mesh lies so far from the origin that such floats do not tell its vertices apart
[[nodiscard]] TANDEM_IO_EXPORT std::string format_glb(const TriangleMesh& mesh);

}  // namespace v0
}  // namespace tandem
