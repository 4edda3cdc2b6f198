#pragma once

#include <string>

#include "tandem/surface/mesh.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// STL, binary: 80 bytes of header, the number of triangles, and for each its normal and corners as floats of
/// 32 bits. @throws InvalidArgument a coordinate does not fit; the mesh lies so far from the origin that such
/// floats do not tell its vertices apart
[[nodiscard]] TANDEM_IO_EXPORT std::string format_stl(const TriangleMesh& mesh);

}  // namespace v0
}  // namespace tandem
