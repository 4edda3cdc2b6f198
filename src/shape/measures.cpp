#include "tandem/shape/measures.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "shape/joint_tangents.h"
#include "shape/plane.h"
#include "tandem/shape/path_view.h"

namespace tandem {
inline namespace v0 {
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
    sum += swept_area(point(3 * i), point(3 * i + 1), point(3 * i + 2), point(3 * i + 3));
  }
  return 4.0 * sum * size * size;
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
