#include "tandem/io/glb.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "io/little_endian.h"
#include "io/mesh_texture.h"
#include "tandem/error.h"
#include "tandem/version.h"

namespace tandem {
inline namespace v0 {
namespace {

// Words of the format (glTF 2.0, sections 3.6 and 4.4).
constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN"
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kVertexBuffer = 34962;
constexpr int kIndexBuffer = 34963;

/// The parts of the file that grow together.
struct Parts {
  std::string bytes;
  std::string views;
  std::string accessors;
  std::string attributes;
  int count = 0;
};

void end_view(Parts& parts, std::size_t from, int target) {
  parts.views += fmt::format(R"({}{{"buffer":0,"byteOffset":{},"byteLength":{},"target":{}}})",
                             parts.count == 0 ? "" : ",", from, parts.bytes.size() - from, target);
}

std::string list(const std::vector<double>& numbers) {
  std::string text;
  for (const double x : numbers) text += fmt::format("{}{}", text.empty() ? "" : ",", static_cast<float>(x));
  return "[" + text + "]";
}

/// Positions must say their bounds, as the floats that they become.
std::string bounds(const Points& points) {
  std::vector<double> lo(points[0].begin(), points[0].end());
  std::vector<double> hi = lo;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < lo.size(); ++k) {
      lo[k] = std::min(lo[k], points[i][k]);
      hi[k] = std::max(hi[k], points[i][k]);
    }
  }
  return fmt::format(R"(,"min":{},"max":{})", list(lo), list(hi));
}

void add_attribute(Parts& parts, std::string_view name, const Points& points, bool bounded) {
  if (points.empty()) return;
  const std::size_t from = parts.bytes.size();
  for (const double x : points.data()) detail::put_float(parts.bytes, x);
  end_view(parts, from, kVertexBuffer);
  parts.accessors += fmt::format(R"({}{{"bufferView":{},"componentType":{},"count":{},"type":"VEC{}"{}}})",
                                 parts.count == 0 ? "" : ",", parts.count, kFloat, points.size(),
                                 points.dim(), bounded ? bounds(points) : "");
  parts.attributes += fmt::format(R"({}"{}":{})", parts.count == 0 ? "" : ",", name, parts.count);
  ++parts.count;
}

void add_indices(Parts& parts, const TriangleMesh& mesh) {
  const std::size_t from = parts.bytes.size();
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t k : triangle) detail::put_half_word(parts.bytes, k);
  }
  end_view(parts, from, kIndexBuffer);
  parts.accessors += fmt::format(R"(,{{"bufferView":{},"componentType":{},"count":{},"type":"SCALAR"}})",
                                 parts.count, kUnsignedInt, 3 * mesh.triangles.size());
}

void append_chunk(std::string& bytes, std::uint32_t kind, std::string content, char padding) {
  content.resize((content.size() + 3) / 4 * 4, padding);
  detail::put_half_word(bytes, static_cast<std::uint32_t>(content.size()));
  detail::put_half_word(bytes, kind);
  bytes += content;
}

}  // namespace

std::string format_glb(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw InvalidArgument("a mesh without triangles, which glTF cannot hold");
  Parts parts;
  detail::check_floats(mesh.vertices.data(), 3);
  add_attribute(parts, "POSITION", mesh.vertices, true);
  add_attribute(parts, "NORMAL", mesh.normals, false);
  add_attribute(parts, "TEXCOORD_0", texture_coordinates(mesh), false);
  add_indices(parts, mesh);
  // The turn by -90 degrees about x brings z up to y.
  const std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0","generator":"Tandem {}"}},"scene":0,"scenes":[{{"nodes":[0]}}],)"
      R"("nodes":[{{"mesh":0,"name":"surface","rotation":[-0.7071067690849304,0,0,0.7071067690849304]}}],)"
      R"("meshes":[{{"primitives":[{{"attributes":{{{}}},"indices":{},"material":0}}]}}],)"
      R"("materials":[{{"doubleSided":true,"pbrMetallicRoughness":{{"baseColorFactor":[0.23,0.45,0.72,1],)"
      R"("metallicFactor":0,"roughnessFactor":0.45}}}}],)"
      R"("accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
      version(), parts.attributes, parts.count, parts.accessors, parts.views, parts.bytes.size());
  std::string chunks;
  append_chunk(chunks, kJsonChunk, json, ' ');
  append_chunk(chunks, kBinChunk, parts.bytes, '\0');
  std::string bytes;
  constexpr std::size_t kHead = 12;
  detail::put_half_word(bytes, kMagic);
  detail::put_half_word(bytes, 2);
  detail::put_half_word(bytes, static_cast<std::uint32_t>(kHead + chunks.size()));
  return bytes + chunks;
}

}  // namespace v0
}  // namespace tandem
