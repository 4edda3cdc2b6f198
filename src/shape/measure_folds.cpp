#include "shape/measure_folds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>

namespace tandem {
inline namespace v0 {
namespace {

// Rows of the raster: a fold of half a percent of the area is some hundred samples' worth.
constexpr std::size_t kRows = 160;

struct VerticalExtent {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();
};

VerticalExtent extent_of(const Flattening& flat) {
  VerticalExtent extent;
  for (const FlatVertex& v : flat.vertices()) {
    extent.lo = std::min(extent.lo, v.y);
    extent.hi = std::max(extent.hi, v.y);
  }
  return extent;
}

class Raster {
 public:
  Raster(VerticalExtent extent, ScanRows& rows)
      : rows_(rows), lo_(extent.lo), step_((extent.hi - extent.lo) / kRows) {}

  // Scanline i is at lo + (i + 1/2) step; an edge holds its lower end and not its upper one.
  void fill(const Flattening& flat) {
    const std::vector<FlatVertex>& v = flat.vertices();
    std::vector<std::size_t>& above = rows_.above_vertex;
    above.resize(v.size());
    for (std::size_t i = 0; i < v.size(); ++i) above[i] = row_from(v[i].y);
    // Where rows begin, from the second on; while they are filled, where the next crossing goes.
    std::vector<std::size_t>& next = rows_.ends;
    next.assign(kRows + 1, 0);
    for_each_edge(flat, [&](std::size_t from, std::size_t to) {
      const auto [first, last] = std::minmax(above[from], above[to]);
      for (std::size_t row = first; row < last; ++row) ++next[row + 1];
    });
    std::partial_sum(next.begin(), next.end(), next.begin());
    rows_.crossings.resize(next.back());
    for_each_edge(flat, [&](std::size_t from, std::size_t to) {
      if (above[from] == above[to]) return;
      const bool up = v[to].y > v[from].y;
      const FlatVertex& lower = up ? v[from] : v[to];
      const FlatVertex& upper = up ? v[to] : v[from];
      const double slope = (upper.x - lower.x) / (upper.y - lower.y);
      const auto [first, last] = std::minmax(above[from], above[to]);
      for (std::size_t row = first; row < last; ++row) {
        rows_.crossings[next[row]++] = {lower.x + (height(row) - lower.y) * slope, up ? 1 : -1};
      }
    });
  }

 private:
  template <class Edge>
  static void for_each_edge(const Flattening& flat, const Edge& edge) {
    for (const FlatPath& path : flat.paths()) {
      for (std::size_t i = path.first; i < path.last; ++i) edge(i, i + 1);
      if (!path.closed) edge(path.last, path.first);
    }
  }
  [[nodiscard]] double height(std::size_t row) const {
    return lo_ + (static_cast<double>(row) + 0.5) * step_;
  }
  // The first scanline at y or above.
  [[nodiscard]] std::size_t row_from(double y) const {
    const double row = (y - lo_) / step_ - 0.5;
    if (!(row > 0.0)) return 0;
    const auto below = static_cast<std::size_t>(std::min(row, static_cast<double>(kRows)));
    return static_cast<double>(below) < row && below < kRows ? below + 1 : below;
  }

  ScanRows& rows_;
  double lo_;
  double step_;
};

void sort_by_x(std::span<ScanCrossing> row) {
  constexpr std::size_t kFew = 24;
  if (row.size() > kFew) {
    std::sort(row.begin(), row.end(), [](const ScanCrossing& a, const ScanCrossing& b) { return a.x < b.x; });
    return;
  }
  for (std::size_t i = 1; i < row.size(); ++i) {
    const ScanCrossing moved = row[i];
    std::size_t to = i;
    for (; to > 0 && moved.x < row[to - 1].x; --to) row[to] = row[to - 1];
    row[to] = moved;
  }
}

}  // namespace

double measure_folds(const Flattening& flat, ScanRows& rows) {
  const VerticalExtent extent = extent_of(flat);
  if (!(extent.hi > extent.lo)) return 0.0;
  Raster(extent, rows).fill(flat);
  double all = 0.0;
  double plus = 0.0;
  double minus = 0.0;
  for (std::size_t begin = 0, k = 0; k < kRows; begin = rows.ends[k++]) {
    const std::span<ScanCrossing> row(rows.crossings.data() + begin, rows.ends[k] - begin);
    sort_by_x(row);
    int winding = 0;
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      winding += row[i].direction;
      const double length = row[i + 1].x - row[i].x;
      if (winding != 0) all += length;
      if (winding == 1) plus += length;
      if (winding == -1) minus += length;
    }
  }
  return all > 0.0 ? 1.0 - std::max(plus, minus) / all : 0.0;
}

}  // namespace v0
}  // namespace tandem
