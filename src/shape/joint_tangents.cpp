#include "shape/joint_tangents.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shape/plane.h"
#include "shape/trigonometry.h"

namespace tandem {
inline namespace v0 {
namespace {

Vec2 point(const PathView& path, std::size_t i) {
  return {path.points[2 * i], path.points[2 * i + 1]};
}

// The difference brought to a largest coordinate of 1, so that products of two neither overflow nor vanish.
Vec2 direction(Vec2 from, Vec2 to) {
  const Vec2 half{0.5 * to.x - 0.5 * from.x, 0.5 * to.y - 0.5 * from.y};
  const double size = std::max(std::abs(half.x), std::abs(half.y));
  return size > 0.0 ? Vec2{half.x / size, half.y / size} : Vec2{};
}

}  // namespace

JointTangents joint_tangents(const PathView& path, std::size_t joint) {
  const std::size_t last = 3 * path.segment_count();
  const std::size_t at = 3 * joint;
  JointTangents tangents;
  if (at == 0 && !path.closed) return tangents;
  const Vec2 p = point(path, at);
  // All other control points, once around; the last one of a closed path is the first.
  const std::size_t steps = path.closed ? last - 1 : last - at;
  for (std::size_t k = 1; k <= steps && tangents.out == Vec2{}; ++k) {
    tangents.out = direction(p, point(path, (at + k) % (path.closed ? last : last + 1)));
  }
  const std::size_t back = path.closed ? last - 1 : at;
  for (std::size_t k = 1; k <= back && tangents.in == Vec2{}; ++k) {
    tangents.in = direction(point(path, path.closed ? (at + last - k) % last : at - k), p);
  }
  return tangents;
}

double break_size(const JointTangents& tangents) {
  const double along = dot(tangents.in, tangents.out);
  const double across = std::abs(cross(tangents.in, tangents.out));
  if (!(std::abs(along) + across > 0.0)) return 0.0;
  const double share = across / (std::abs(along) + across);
  return along >= 0.0 ? share : 2.0 - share;
}

double break_angle(double size) {
  const double share = size <= 1.0 ? size : 2.0 - size;
  const double degrees = angle_degrees(1.0 - share, share);
  return (size <= 1.0 ? degrees : 180.0 - degrees) * (std::numbers::pi / 180.0);
}

}  // namespace v0
}  // namespace tandem
