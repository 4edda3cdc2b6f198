#include "surface/grid_cell.h"

#include <algorithm>
#include <cmath>

#include "surface/surface_evaluator.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Distances of two diagonals from the middle that differ by less, in units of the extent, are equal: flat and
// symmetric cells shall not be cut as rounding wants.
constexpr double kSame = 1e-12;

constexpr CellTriangles kAlong{{{0, 1, 2}, {0, 2, 3}}};
constexpr CellTriangles kAcross{{{0, 1, 3}, {1, 2, 3}}};

bool looks_away(const CellCorners<Vector3>& corners, const CellTriangles& triangles, const Vector3& normal) {
  return std::any_of(triangles.begin(), triangles.end(), [&](const std::array<std::size_t, 3>& t) {
    return dot(cross(corners[t[1]] - corners[t[0]], corners[t[2]] - corners[t[0]]), normal) < 0.0;
  });
}

double distance_to_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const Vector3 d = b - a;
  const double square = dot(d, d);
  const double t = square > 0.0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0.0;
  return length(p - (a + t * d));
}

}  // namespace

ScaledSurface::ScaledSurface(const Surface& surface) : surface_(surface) {
  const auto first = surface.control_points().front();
  std::copy(first.begin(), first.end(), origin_.begin());
}

Vector3 ScaledSurface::point(double u, double v) const {
  Vector3 p{};
  const auto place = std::span<double>(p).first(static_cast<std::size_t>(surface_.dim()));
  SurfaceEvaluator(surface_).point(u, v, place);
  return scaled(place);
}

Vector3 ScaledSurface::scaled(std::span<const double> point) const {
  if (!(surface_.extent() > 0.0)) return {};
  Vector3 p{};
  for (std::size_t c = 0; c < point.size(); ++c)
    p[c] = point[c] / surface_.extent() - origin_[c] / surface_.extent();
  return p;
}

Vector3 ScaledSurface::normal(double u, double v, SurfaceSides sides) const {
  if (surface_.dim() == 3) {
    const Point n = surface_.normal(u, v, sides);
    return {n[0], n[1], n[2]};
  }
  const Points rows = surface_.derivatives(u, v, 1, sides);
  const double a = std::max(std::fabs(rows[1][0]), std::fabs(rows[1][1]));
  const double b = std::max(std::fabs(rows[2][0]), std::fabs(rows[2][1]));
  if (!(a > 0.0 && b > 0.0)) return {};
  const double jacobian = rows[1][0] / a * (rows[2][1] / b) - rows[1][1] / a * (rows[2][0] / b);
  if (jacobian == 0.0) return {};
  return {0.0, 0.0, jacobian > 0.0 ? 1.0 : -1.0};
}

CellTriangles split_cell(const CellCorners<Vector3>& corners, const Vector3& middle, const Vector3& normal) {
  const bool along_looks_away = looks_away(corners, kAlong, normal);
  const bool across_looks_away = looks_away(corners, kAcross, normal);
  if (along_looks_away != across_looks_away) return along_looks_away ? kAcross : kAlong;
  const double along = distance_to_segment(middle, corners[0], corners[2]);
  const double across = distance_to_segment(middle, corners[1], corners[3]);
  if (std::fabs(along - across) > kSame) return along < across ? kAlong : kAcross;
  const bool longer = length(corners[2] - corners[0]) > length(corners[3] - corners[1]) + kSame;
  return longer ? kAcross : kAlong;
}

double distance_to_triangle(const Vector3& p, const std::array<Vector3, 3>& t) {
  const Vector3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double square = dot(n, n);
  bool above = square > 0.0;
  for (std::size_t k = 0; k < 3 && above; ++k) {
    above = dot(cross(t[(k + 1) % 3] - t[k], p - t[k]), n) >= 0.0;
  }
  if (above) return std::fabs(dot(p - t[0], n)) / std::sqrt(square);
  return std::min({distance_to_segment(p, t[0], t[1]), distance_to_segment(p, t[1], t[2]),
                   distance_to_segment(p, t[2], t[0])});
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
