#include "tandem/shape/measures.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "shape/joint_tangents.h"
#include "shape/plane.h"
#include "tandem/shape/path_view.h"

namespace tandem {
inline namespace v0 {
namespace {

// Twice what the cubic sweeps over as seen from the origin, times 10: the integral of x dy - y dx of its
// Bernstein form.
double swept(Vec2 p0, Vec2 p1, Vec2 p2, Vec2 p3) {
  return 6.0 * cross(p0, p1) + 3.0 * cross(p0, p2) + cross(p0, p3) + 3.0 * cross(p1, p2) +
         3.0 * cross(p1, p3) + 6.0 * cross(p2, p3);
}

}  // namespace

double signed_area(const CubicPath& path) {
  const PathView view = view_paths({&path, 1}).front();
  const Vec2 origin{view.points[0], view.points[1]};
  double size = 0.0;
  for (std::size_t i = 0; i < view.points.size(); i += 2) {
    size = std::max({size, std::abs(0.5 * view.points[i] - 0.5 * origin.x),
                     std::abs(0.5 * view.points[i + 1] - 0.5 * origin.y)});
  }
  if (!(size > 0.0)) return 0.0;
  const auto point = [&](std::size_t i) {
    return Vec2{(0.5 * view.points[2 * i] - 0.5 * origin.x) / size,
                (0.5 * view.points[2 * i + 1] - 0.5 * origin.y) / size};
  };
  // About the first point, so that the line that closes an open path sweeps over nothing.
  double sum = 0.0;
  for (std::size_t i = 0; i < view.segment_count(); ++i) {
    sum += swept(point(3 * i), point(3 * i + 1), point(3 * i + 2), point(3 * i + 3));
  }
  return sum / 20.0 * 4.0 * size * size;
}

std::vector<double> tangent_breaks(const CubicPath& path) {
  const PathView view = view_paths({&path, 1}).front();
  std::vector<double> breaks(view.segment_count());
  for (std::size_t i = 0; i < breaks.size(); ++i)
    breaks[i] = break_angle(break_size(joint_tangents(view, i)));
  return breaks;
}

}  // namespace v0
}  // namespace tandem
