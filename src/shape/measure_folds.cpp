#include "shape/measure_folds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

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
  Raster(VerticalExtent extent, std::vector<std::vector<ScanCrossing>>& rows)
      : rows_(rows), lo_(extent.lo), step_((extent.hi - extent.lo) / kRows) {
    rows_.resize(kRows);
    for (std::vector<ScanCrossing>& row : rows_) row.clear();
  }

  // Scanline i is at lo + (i + 1/2) step; an edge holds its lower end and not its upper one.
  void add(const FlatVertex& from, const FlatVertex& to) {
    const bool up = to.y > from.y;
    const FlatVertex& lower = up ? from : to;
    const FlatVertex& upper = up ? to : from;
    const std::size_t first = row_from(lower.y);
    const std::size_t last = row_from(upper.y);
    if (first == last) return;
    const double slope = (upper.x - lower.x) / (upper.y - lower.y);
    for (std::size_t i = first; i < last; ++i) {
      rows_[i].push_back({lower.x + (height(i) - lower.y) * slope, up ? 1 : -1});
    }
  }

 private:
  [[nodiscard]] double height(std::size_t row) const {
    return lo_ + (static_cast<double>(row) + 0.5) * step_;
  }
  // The first scanline at y or above.
  [[nodiscard]] std::size_t row_from(double y) const {
    const double row = std::ceil((y - lo_) / step_ - 0.5);
    return row <= 0.0 ? 0 : std::min(kRows, static_cast<std::size_t>(row));
  }

  std::vector<std::vector<ScanCrossing>>& rows_;
  double lo_;
  double step_;
};

}  // namespace

double measure_folds(const Flattening& flat, std::vector<std::vector<ScanCrossing>>& rows) {
  const VerticalExtent extent = extent_of(flat);
  if (!(extent.hi > extent.lo)) return 0.0;
  Raster raster(extent, rows);
  const std::vector<FlatVertex>& v = flat.vertices();
  for (const FlatPath& path : flat.paths()) {
    for (std::size_t i = path.first; i < path.last; ++i) raster.add(v[i], v[i + 1]);
    if (!path.closed) raster.add(v[path.last], v[path.first]);
  }
  double all = 0.0;
  double plus = 0.0;
  double minus = 0.0;
  for (std::vector<ScanCrossing>& row : rows) {
    std::sort(row.begin(), row.end(), [](const ScanCrossing& a, const ScanCrossing& b) { return a.x < b.x; });
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
