#include "tandem/surface/mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "surface/vector3.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::Vector3;
using detail::operator-;

Vector3 vertex(const TriangleMesh& mesh, std::uint32_t i) {
  const auto p = mesh.vertices[i];
  return {p[0], p[1], p[2]};
}

// Twice the area, along the normal.
Vector3 twice_area(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Vector3 a = vertex(mesh, triangle[0]);
  return detail::cross(vertex(mesh, triangle[1]) - a, vertex(mesh, triangle[2]) - a);
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> boundary_edges(const TriangleMesh& mesh) {
  struct Edge {
    std::array<std::uint32_t, 2> ends;  // the smaller index first
    int sense;                          // 1: run through in that order
  };
  std::vector<Edge> edges;
  edges.reserve(mesh.triangles.size() * 3);
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k];
      const std::uint32_t to = t[(k + 1) % 3];
      edges.push_back(from < to ? Edge{{from, to}, 1} : Edge{{to, from}, -1});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
  std::vector<std::array<std::uint32_t, 2>> boundary;
  for (std::size_t i = 0; i < edges.size();) {
    int sum = 0;
    std::size_t j = i;
    for (; j < edges.size() && edges[j].ends == edges[i].ends; ++j) sum += edges[j].sense;
    for (; sum > 0; --sum) boundary.push_back(edges[i].ends);
    for (; sum < 0; ++sum) boundary.push_back({edges[i].ends[1], edges[i].ends[0]});
    i = j;
  }
  return boundary;
}

bool is_watertight(const TriangleMesh& mesh) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(mesh.triangles.size() * 3);
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({t[k], t[(k + 1) % 3]});
  }
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
  return !edges.empty() && boundary_edges(mesh).empty();
}

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    sum += detail::length(twice_area(mesh, t));
  }
  return sum / 2.0;
}

double volume(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return 0.0;
  // Seen from a vertex of its own: far from the origin nothing is lost.
  const Vector3 origin = vertex(mesh, mesh.triangles.front()[0]);
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vector3 a = vertex(mesh, t[0]) - origin;
    const Vector3 b = vertex(mesh, t[1]) - origin;
    const Vector3 c = vertex(mesh, t[2]) - origin;
    sum += detail::dot(a, detail::cross(b, c));
  }
  return sum / 6.0;
}

std::array<double, 3> facet_normal(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Vector3 a = vertex(mesh, triangle[0]);
  Vector3 b = vertex(mesh, triangle[1]) - a;
  Vector3 c = vertex(mesh, triangle[2]) - a;
  // Scaled before they are multiplied: sizes of 1e-300 and 1e300 are legal.
  for (Vector3* edge : {&b, &c}) {
    double largest = 0.0;
    for (const double x : *edge) largest = std::max(largest, std::fabs(x));
    if (!(largest > 0.0)) return {};
    for (double& x : *edge) x /= largest;
  }
  return detail::unit(detail::cross(b, c));
}

}  // namespace v0
}  // namespace tandem
