#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "tandem/shape/cubic_path.h"

/// Simple loops for tests of blends, and what is measured on them.
namespace tandem::test {

/// A loop about the origin, of size about 2, that does not cross itself and is smooth at every joint.
inline CubicPath smooth_star(std::mt19937& random, std::size_t segments) {
  std::uniform_real_distribution<double> radius(0.6, 1.4);
  std::uniform_real_distribution<double> handle(0.25, 0.4);
  std::uniform_real_distribution<double> tilt(-0.3, 0.3);
  const double step = 2.0 * std::numbers::pi / static_cast<double>(segments);
  struct Joint {
    double x, y, tx, ty;
  };
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < segments; ++i) {
    const double angle = step * static_cast<double>(i);
    const double r = radius(random);
    const double heading = angle + 0.5 * std::numbers::pi + tilt(random);
    joints.push_back(
        {r * std::cos(angle), r * std::sin(angle), step * std::cos(heading), step * std::sin(heading)});
  }
  Points points;
  points.push_back(Point{joints[0].x, joints[0].y});
  for (std::size_t i = 0; i < segments; ++i) {
    const Joint& p = joints[i];
    const Joint& q = joints[(i + 1) % segments];
    const double out = handle(random);
    const double in = handle(random);
    points.push_back(Point{p.x + out * p.tx, p.y + out * p.ty});
    points.push_back(Point{q.x - in * q.tx, q.y - in * q.ty});
    points.push_back(Point{q.x, q.y});
  }
  return CubicPath(std::move(points), true);
}

inline double edge_length(const Points& p, std::size_t i) {
  return std::hypot(p[i + 1][0] - p[i][0], p[i + 1][1] - p[i][1]);
}

/// The turn (radians) at joint j; 0 for the seam of closed paths. Handles of no length point to the next
/// control point that is elsewhere.
inline double turn_at(const CubicPath& path, std::size_t j) {
  const std::size_t n = path.segment_count();
  const auto before = path.segment((j + n - 1) % n);
  const auto after = path.segment(j % n);
  const auto direction = [](const auto& from, const auto& to) {
    return std::pair(to[0] - from[0], to[1] - from[1]);
  };
  std::pair<double, double> in;
  std::pair<double, double> out;
  for (std::size_t k = 3; k-- > 0;) {
    in = direction(before[k], before[3]);
    if (std::hypot(in.first, in.second) > 1e-12) break;
  }
  for (std::size_t k = 1; k < 4; ++k) {
    out = direction(after[0], after[k]);
    if (std::hypot(out.first, out.second) > 1e-12) break;
  }
  const double cross = in.first * out.second - in.second * out.first;
  const double dot = in.first * out.first + in.second * out.second;
  return std::fabs(std::atan2(cross, dot));
}

inline double largest_turn(const CubicPath& path) {
  double most = 0.0;
  for (std::size_t j = path.is_closed() ? 0 : 1; j < path.segment_count(); ++j) {
    most = std::max(most, turn_at(path, j));
  }
  return most;
}

/// Turned about the origin, then moved.
inline CubicPath turned(const CubicPath& path, double degrees, double dx = 0.0, double dy = 0.0) {
  const double c = std::cos(degrees * std::numbers::pi / 180.0);
  const double s = std::sin(degrees * std::numbers::pi / 180.0);
  Points points = path.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i][0];
    const double y = points[i][1];
    points[i][0] = c * x - s * y + dx;
    points[i][1] = s * x + c * y + dy;
  }
  return CubicPath(std::move(points), path.is_closed());
}

}  // namespace tandem::test
