#include "shape/interior_samples.h"

#include <algorithm>
#include <limits>

#include "shape/measure_folds.h"

namespace tandem {
inline namespace v0 {
namespace {

// Scanlines across a contour, and points on each stretch of one inside it.
constexpr int kLines = 13;
constexpr int kPoints = 4;

/// Calls edge(from, to) for each edge of the path, closed.
template <class Edge>
void for_each_edge(const Flattening& flat, const FlatPath& path, Edge edge) {
  const std::vector<FlatVertex>& v = flat.vertices();
  for (std::size_t i = path.first; i < path.last; ++i) edge(v[i], v[i + 1]);
  if (!path.closed) edge(v[path.last], v[path.first]);
}

// Where an edge crosses the height y, if it does; an edge holds its lower end and not its upper one.
template <class Crossed>
void cross_edge(const FlatVertex& a, const FlatVertex& b, double y, Crossed crossed) {
  if ((a.y <= y) == (b.y <= y)) return;
  crossed(ScanCrossing{a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), b.y > a.y ? 1 : -1});
}

}  // namespace

std::vector<InteriorSample> sample_interior(const Flattening& flat, const FlatPath& path) {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -lo;
  for (std::size_t i = path.first; i <= path.last; ++i) {
    lo = std::min(lo, flat.vertices()[i].y);
    hi = std::max(hi, flat.vertices()[i].y);
  }
  std::vector<InteriorSample> samples;
  std::vector<ScanCrossing> row;
  const double height = (hi - lo) / kLines;
  for (int line = 0; line < kLines; ++line) {
    const double y = lo + (line + 0.5) * height;
    row.clear();
    for_each_edge(flat, path, [&](const FlatVertex& a, const FlatVertex& b) {
      cross_edge(a, b, y, [&](const ScanCrossing& c) { row.push_back(c); });
    });
    std::sort(row.begin(), row.end(), [](const ScanCrossing& a, const ScanCrossing& b) { return a.x < b.x; });
    int winding = 0;
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      winding -= row[i].direction;
      const double width = (row[i + 1].x - row[i].x) / kPoints;
      if (winding == 0 || !(width > 0.0)) continue;
      for (int k = 0; k < kPoints; ++k) {
        samples.push_back({{row[i].x + (k + 0.5) * width, y}, width * height});
      }
    }
  }
  return samples;
}

int winding_number(const Flattening& flat, const FlatPath& path, Vec2 p) {
  int winding = 0;
  for_each_edge(flat, path, [&](const FlatVertex& a, const FlatVertex& b) {
    cross_edge(a, b, p.y, [&](const ScanCrossing& c) {
      if (c.x > p.x) winding += c.direction;
    });
  });
  return winding;
}

}  // namespace v0
}  // namespace tandem
