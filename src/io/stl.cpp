#include "tandem/io/stl.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "io/little_endian.h"

namespace tandem {
inline namespace v0 {

std::string format_stl(const TriangleMesh& mesh) {
  detail::check_floats(mesh.vertices.data(), 3);
  constexpr std::size_t kHead = 80;
  constexpr std::size_t kTriangle = 50;
  // It must not begin with "solid", which the text form does.
  std::string bytes = "Tandem, binary STL";
  bytes.resize(kHead, ' ');
  bytes.reserve(kHead + 4 + mesh.triangles.size() * kTriangle);
  detail::put_half_word(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (const double x : facet_normal(mesh, triangle)) detail::put_float(bytes, x);
    for (const std::uint32_t k : triangle) {
      for (const double x : mesh.vertices[k]) detail::put_float(bytes, x);
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

}  // namespace v0
}  // namespace tandem
