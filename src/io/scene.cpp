#include "tandem/io/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "tandem/error.h"
#include "tandem/surface/edit.h"

namespace tandem {
inline namespace v0 {
namespace {

// Iso-lines of both families together, and the fewest and most of one.
constexpr double kLines = 34.0;
constexpr double kFewest = 5.0;
constexpr double kMost = 28.0;
// Samples of a line: per span, and altogether.
constexpr std::size_t kPerSpan = 16;
constexpr std::size_t kFewestSamples = 128;
constexpr std::size_t kMostSamples = 768;
// A line that is no longer than this share of the extent is a point.
constexpr double kPoint = 1e-9;

constexpr Along across(Along along) {
  return along == Along::u ? Along::v : Along::u;
}

/// Places along a domain: evenly, and its knots, where corners are.
std::vector<double> samples_of(const std::vector<double>& knots, Interval domain) {
  std::vector<double> result;
  for (const double knot : knots) {
    if (domain.contains(knot)) result.push_back(knot);
  }
  result.erase(std::unique(result.begin(), result.end()), result.end());
  const std::size_t count = std::clamp(kPerSpan * result.size(), kFewestSamples, kMostSamples);
  for (std::size_t i = 0; i <= count; ++i) {
    result.push_back(domain.lo + domain.length() * static_cast<double>(i) / static_cast<double>(count));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Points polyline(const Curve& curve) {
  if (curve.dim() != 2 && curve.dim() != 3) {
    throw InvalidArgument(fmt::format("a curve in dimension {} in a picture, expected 2 or 3", curve.dim()));
  }
  const std::vector<double> places = samples_of(curve.knots(), curve.domain());
  Points line(3, places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Point p = curve.evaluate(places[i]);
    std::copy(p.begin(), p.end(), line[i].begin());
  }
  return line;
}

/// In units of the extent.
double length_of(const Points& line, double extent) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size() && extent > 0.0; ++i) {
    double square = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = (line[i][k] - line[i - 1][k]) / extent;
      square += d * d;
    }
    sum += std::sqrt(square);
  }
  return sum;
}

/// Mean length of some curves along a parameter.
double mean_length(const Surface& surface, Along along) {
  constexpr int kProbes = 5;
  const Interval other = surface.domain(across(along));
  double sum = 0.0;
  for (int i = 0; i < kProbes; ++i) {
    const double t = other.lo + other.length() * i / (kProbes - 1);
    sum += length_of(polyline(iso_curve(surface, along, t)), surface.extent());
  }
  return sum / kProbes;
}

void add_iso_lines(Scene& scene, const Surface& surface, Along along, std::size_t count) {
  const Interval other = surface.domain(across(along));
  // The ends are edges, unless they are one line.
  for (std::size_t i = surface.is_closed(across(along)) ? 0 : 1; i < count; ++i) {
    const double t = other.lo + other.length() * static_cast<double>(i) / static_cast<double>(count);
    scene.iso_lines.push_back(polyline(iso_curve(surface, along, t)));
  }
}

void add_edges(Scene& scene, const Surface& surface, Along along) {
  if (surface.is_closed(across(along))) return;
  const Interval other = surface.domain(across(along));
  for (const double t : {other.lo, other.hi}) {
    Points line = polyline(iso_curve(surface, along, t));
    if (length_of(line, surface.extent()) > kPoint) scene.edges.push_back(std::move(line));
  }
}

void add_curves(Scene& scene, std::span<const Curve> curves) {
  for (const Curve& curve : curves) scene.curves.push_back(polyline(curve));
}

/// Directed edges joined to lines.
std::vector<Points> chain(const TriangleMesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& edges) {
  std::multimap<std::uint32_t, std::uint32_t> next;
  for (const auto& [from, to] : edges) next.emplace(from, to);
  std::vector<Points> lines;
  while (!next.empty()) {
    Points line;
    std::uint32_t at = next.begin()->first;
    line.push_back(mesh.vertices[at]);
    for (auto found = next.find(at); found != next.end(); found = next.find(at)) {
      at = found->second;
      next.erase(found);
      line.push_back(mesh.vertices[at]);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

bool folds(const TriangleMesh& mesh) {
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t k : triangle) {
      if (mesh.normals[k][2] * mesh.normals[mesh.triangles.front()[0]][2] < 0.0) return true;
    }
  }
  return false;
}

/// The same surface with so many knots that folds are seen where they are.
Surface with_more_knots(const Surface& surface, Along along) {
  constexpr int kLinesAcross = 96;
  const Interval domain = surface.domain(along);
  const std::vector<double>& old = surface.knots(along);
  std::vector<double> knots;
  for (int i = 1; i < kLinesAcross; ++i) {
    const double t = domain.lo + domain.length() * i / kLinesAcross;
    if (!std::binary_search(old.begin(), old.end(), t)) knots.push_back(t);
  }
  return refine(surface, along, knots);
}

}  // namespace

Scene scene_of(const Surface& surface, std::span<const Curve> curves, TessellateOptions options) {
  options.joints = Joints::split;
  Scene scene;
  scene.mesh = tessellate(surface, options);
  scene.planar = surface.dim() == 2;
  if (scene.planar && folds(scene.mesh)) {
    scene.mesh = tessellate(with_more_knots(with_more_knots(surface, Along::u), Along::v), options);
  }
  const double u = mean_length(surface, Along::u);
  const double v = mean_length(surface, Along::v);
  // As many along one as the other is long.
  const double share = u + v > 0.0 ? u / (u + v) : 0.5;
  const auto count = [](double lines) { return static_cast<std::size_t>(std::clamp(lines, kFewest, kMost)); };
  add_iso_lines(scene, surface, Along::v, count(kLines * share));
  add_iso_lines(scene, surface, Along::u, count(kLines * (1.0 - share)));
  add_edges(scene, surface, Along::u);
  add_edges(scene, surface, Along::v);
  add_curves(scene, curves);
  return scene;
}

Scene scene_of(TriangleMesh mesh, std::span<const Curve> curves) {
  Scene scene;
  scene.mesh = std::move(mesh);
  scene.edges = chain(scene.mesh, boundary_edges(scene.mesh));
  add_curves(scene, curves);
  return scene;
}

}  // namespace v0
}  // namespace tandem
