#include "tandem/io/surface_page.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "io/base64.h"
#include "io/camera.h"
#include "io/faces.h"
#include "io/html.h"
#include "io/little_endian.h"
#include "io/page.h"
#include "io/scene_ball.h"
#include "io/surface_page_moves.h"
#include "io/surface_page_text.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::SceneBall;

// Pixels of the picture by which it is told what the front is.
constexpr int kGlance = 256;

/// In the unit ball (of directions: that about the origin), planar ones with y up.
void put_vector(std::string& bytes, const Scene& scene, std::span<const double> v, const SceneBall& ball) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = v[k] / ball.radius - ball.center[k] / ball.radius;
    detail::put_float(bytes, scene.planar && k == 1 ? -x : x);
  }
}

std::string vectors(const Scene& scene, const Points& points, const SceneBall& ball) {
  std::string bytes;
  for (std::size_t i = 0; i < points.size(); ++i) put_vector(bytes, scene, points[i], ball);
  return to_base64(bytes);
}

/// Points with 1 behind them, and four zeros after each line.
std::string polylines(const Scene& scene, const std::vector<Points>& lines, const SceneBall& ball) {
  std::string bytes;
  for (const Points& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      put_vector(bytes, scene, line[i], ball);
      detail::put_float(bytes, 1.0);
    }
    for (int k = 0; k < 4; ++k) detail::put_float(bytes, 0.0);
  }
  return to_base64(bytes);
}

std::string indices(const TriangleMesh& mesh) {
  std::string bytes;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t k : triangle) detail::put_half_word(bytes, k);
  }
  return to_base64(bytes);
}

/// A mesh without normals gets those of its triangles, and corners of its own for each.
TriangleMesh with_normals(const TriangleMesh& mesh) {
  if (!mesh.normals.empty()) return mesh;
  TriangleMesh result;
  for (const auto& triangle : mesh.triangles) {
    const auto normal = facet_normal(mesh, triangle);
    const auto first = static_cast<std::uint32_t>(result.vertices.size());
    for (const std::uint32_t k : triangle) {
      result.vertices.push_back(mesh.vertices[k]);
      result.normals.push_back(normal);
    }
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

std::string scene_data(const Scene& scene) {
  const SceneBall ball = detail::ball_of(scene);
  const detail::Camera camera(scene);
  const bool front = detail::Faces(scene, camera, kGlance).shows_fronts();
  const TriangleMesh mesh = with_normals(scene.mesh);
  return fmt::format(
      "{{\"planar\":{},\"front\":{},\"azimuth\":{},\"elevation\":{},\n\"positions\":\"{}\",\n\"normals\":\"{}"
      "\",\n"
      "\"triangles\":\"{}\",\n\"iso\":\"{}\",\n\"edge\":\"{}\",\n\"curve\":\"{}\"}}",
      scene.planar, front ? 1 : -1, camera.azimuth(), camera.elevation(), vectors(scene, mesh.vertices, ball),
      vectors(scene, mesh.normals, {}), indices(mesh), polylines(scene, scene.iso_lines, ball),
      polylines(scene, scene.edges, ball), polylines(scene, scene.curves, ball));
}

}  // namespace

std::string format_scene_page(const Scene& scene, const std::string& title) {
  detail::check_scene(scene);
  return format_page(
      {title, kSurfaceStyle, kSurfaceBody, scene_data(scene), std::string(kSurfaceScript) + kSurfaceMoves});
}

}  // namespace v0
}  // namespace tandem
