#include "tandem/io/ply.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

#include "io/little_endian.h"

namespace tandem {
inline namespace v0 {

std::string format_ply(const TriangleMesh& mesh) {
  const bool normals = !mesh.normals.empty();
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment Tandem\nelement vertex {}\n"
      "property double x\nproperty double y\nproperty double z\n{}"
      "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      mesh.vertices.size(), normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "",
      mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (const double x : mesh.vertices[i]) detail::put_number(bytes, x);
    if (!normals) continue;
    for (const double x : mesh.normals[i]) detail::put_float(bytes, x);
  }
  for (const auto& triangle : mesh.triangles) {
    bytes += '\3';
    for (const std::uint32_t k : triangle) detail::put_half_word(bytes, k);
  }
  return bytes;
}

}  // namespace v0
}  // namespace tandem
