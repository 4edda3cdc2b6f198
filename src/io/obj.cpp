#include "tandem/io/obj.h"

#include <cstddef>
#include <string_view>

#include "io/mesh_texture.h"
#include "io/number.h"

namespace tandem {
inline namespace v0 {
namespace {

void append_lines(std::string& text, std::string_view keyword, const Points& points, int precision) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += keyword;
    for (const double x : points[i]) {
      text += ' ';
      append_number(text, x, precision);
    }
    text += '\n';
  }
}

}  // namespace

std::string format_obj(const TriangleMesh& mesh) {
  constexpr int kDecimals = 7;  // of normals and texture coordinates, which are of size 1
  std::string text = "# Tandem\n";
  append_lines(text, "v", mesh.vertices, -1);
  append_lines(text, "vt", texture_coordinates(mesh), kDecimals);
  append_lines(text, "vn", mesh.normals, kDecimals);
  for (const auto& triangle : mesh.triangles) {
    text += 'f';
    for (const std::uint32_t k : triangle) {
      const std::string index = std::to_string(std::size_t{k} + 1);
      text += ' ' + index;
      if (mesh.parameters.empty() && mesh.normals.empty()) continue;
      text += '/' + (mesh.parameters.empty() ? "" : index);
      if (!mesh.normals.empty()) text += '/' + index;
    }
    text += '\n';
  }
  return text;
}

}  // namespace v0
}  // namespace tandem
