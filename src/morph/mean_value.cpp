#include "morph/mean_value.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Chords of a segment that stand for it.
constexpr int kChords = 4;

std::vector<Vec2> polygon_of(const CubicPath& path) {
  std::vector<Vec2> polygon;
  for (std::size_t i = 0; i < path.segment_count(); ++i) {
    const auto p = path.segment(i);
    for (int k = 0; k < kChords; ++k) {
      const double t = static_cast<double>(k) / kChords;
      const double u = 1.0 - t;
      const auto at = [&](std::size_t c) {
        return u * u * u * p[0][c] + 3.0 * u * u * t * p[1][c] + 3.0 * u * t * t * p[2][c] +
               t * t * t * p[3][c];
      };
      polygon.push_back({at(0), at(1)});
    }
  }
  return polygon;
}

double length(Vec2 v) {
  return std::sqrt(v.x * v.x + v.y * v.y);
}

}  // namespace

Vec2 carried_along(Vec2 point, const CubicPath& from, const CubicPath& to) {
  const std::vector<Vec2> p = polygon_of(from);
  const std::vector<Vec2> q = polygon_of(to);
  const std::size_t n = p.size();
  std::vector<Vec2> d(n);
  for (std::size_t i = 0; i < n; ++i) {
    d[i] = {p[i].x - point.x, p[i].y - point.y};
    if (d[i] == Vec2{}) return q[i];
  }
  double whole = 0.0;
  Vec2 sum;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const double ri = length(d[i]);
    const double rj = length(d[j]);
    const double cross = d[i].x * d[j].y - d[i].y * d[j].x;
    const double dot = d[i].x * d[j].x + d[i].y * d[j].y;
    if (cross == 0.0) {
      if (dot >= 0.0) continue;  // seen edge on
      const double t = ri / (ri + rj);
      return {(1.0 - t) * q[i].x + t * q[j].x, (1.0 - t) * q[i].y + t * q[j].y};
    }
    // tan of half the angle at which the edge is seen.
    const double half = (ri * rj - dot) / cross;
    whole += half / ri + half / rj;
    sum.x += half / ri * q[i].x + half / rj * q[j].x;
    sum.y += half / ri * q[i].y + half / rj * q[j].y;
  }
  return whole != 0.0 ? Vec2{sum.x / whole, sum.y / whole} : point;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
