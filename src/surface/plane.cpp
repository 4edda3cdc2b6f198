#include "surface/plane.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "match/vector.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

constexpr double kInPlane = 1e-9;

/// The point's part across the axes so far, relative to the origin. Halved coordinates keep huge ones finite.
Point across(std::span<const double> point, const Plane& plane) {
  Point d(point.size());
  for (std::size_t c = 0; c < d.size(); ++c) d[c] = 0.5 * point[c] - 0.5 * plane.origin[c];
  for (const Point* axis : {&plane.x, &plane.y}) {
    if (axis->empty()) continue;
    const double along = dot(d, *axis);
    for (std::size_t c = 0; c < d.size(); ++c) d[c] -= along * (*axis)[c];
  }
  return d;
}

/// The longest of these, and its length.
std::pair<Point, double> furthest(std::span<const Points* const> clouds, const Plane& plane) {
  Point furthest(plane.origin.size(), 0.0);
  double length = 0.0;
  for (const Points* cloud : clouds) {
    for (std::size_t i = 0; i < cloud->size(); ++i) {
      Point unit = across((*cloud)[i], plane);
      const double own = normalize(unit);
      if (own <= length) continue;
      length = own;
      furthest = std::move(unit);
    }
  }
  return {std::move(furthest), length};
}

Point unit_vector(std::size_t dim, std::size_t axis) {
  Point unit(dim, 0.0);
  unit[axis] = 1.0;
  return unit;
}

}  // namespace

std::optional<Plane> common_plane(std::span<const Points* const> clouds) {
  const auto first = (*clouds.front())[0];
  Plane plane{Point(first.begin(), first.end()), {}, {}};
  auto [x, size] = furthest(clouds, plane);
  plane.x = std::move(x);
  auto [y, width] = furthest(clouds, plane);
  plane.is_line = width <= kInPlane * size;
  plane.y = std::move(y);
  if (first.size() == 2) {
    // No turn of the coordinates where none is needed.
    plane.origin = {0.0, 0.0};
    plane.x = unit_vector(2, 0);
    plane.y = unit_vector(2, 1);
    return plane;
  }
  plane.width = width;
  if (plane.is_line) return plane;
  plane.thickness = furthest(clouds, plane).second;
  if (plane.thickness > kInPlane * size) return std::nullopt;
  return plane;
}

std::optional<Plane> common_plane(std::span<const Curve> curves) {
  std::vector<const Points*> clouds;
  for (const Curve& curve : curves) clouds.push_back(&curve.control_points());
  return common_plane(std::span<const Points* const>(clouds));
}

Curve in_plane(const Curve& curve, const Plane& plane) {
  if (curve.dim() == 2) return curve;
  Points points(2, curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const auto from = curve.control_points()[i];
    for (std::size_t c = 0; c < from.size(); ++c) {
      const double d = from[c] - plane.origin[c];
      points[i][0] += d * plane.x[c];
      points[i][1] += d * plane.y[c];
    }
  }
  return Curve(curve.degree(), curve.knots(), std::move(points), curve.weights());
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
