#include "morph/measures.h"

#include <array>
#include <cmath>

#include "shape/plane.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// 1 - cos of 0.05 rad, below which a joint counts as smooth (see MatchOptions::corner_angle).
constexpr double kSmooth = 0.00125;

}  // namespace

double signed_area(std::span<const double> p) {
  const Vec2 origin{p[0], p[1]};
  const auto point = [&](std::size_t i) { return Vec2{p[i] - origin.x, p[i + 1] - origin.y}; };
  double sum = 0.0;
  for (std::size_t i = 0; i + 7 < p.size(); i += 6) {
    sum += swept_area(point(i), point(i + 2), point(i + 4), point(i + 6));
  }
  return sum;
}

double path_length(std::span<const double> p) {
  constexpr std::array<double, 5> kNodes = {0.046910077030668, 0.230765344947158, 0.5, 0.769234655052842,
                                            0.953089922969332};
  constexpr std::array<double, 5> kWeights = {0.118463442528095, 0.239314335249683, 0.284444444444444,
                                              0.239314335249683, 0.118463442528095};
  double sum = 0.0;
  for (std::size_t i = 0; i + 7 < p.size(); i += 6) {
    for (std::size_t k = 0; k < kNodes.size(); ++k) {
      const double t = kNodes[k];
      const double u = 1.0 - t;
      const auto speed = [&](std::size_t c) {
        return 3.0 * (u * u * (p[i + 2 + c] - p[i + c]) + 2.0 * u * t * (p[i + 4 + c] - p[i + 2 + c]) +
                      t * t * (p[i + 6 + c] - p[i + 4 + c]));
      };
      const double x = speed(0);
      const double y = speed(1);
      sum += kWeights[k] * std::sqrt(x * x + y * y);
    }
  }
  return sum;
}

Vec2 center_of_edges(std::span<const double> p) {
  double x = 0.0;
  double y = 0.0;
  double whole = 0.0;
  for (std::size_t i = 0; i + 3 < p.size(); i += 2) {
    const double dx = p[i + 2] - p[i];
    const double dy = p[i + 3] - p[i + 1];
    const double length = std::sqrt(dx * dx + dy * dy);
    x += length * (0.5 * p[i] + 0.5 * p[i + 2]);
    y += length * (0.5 * p[i + 1] + 0.5 * p[i + 3]);
    whole += length;
  }
  return whole > 0.0 ? Vec2{x / whole, y / whole} : Vec2{p[0], p[1]};
}

double direction_break(std::span<const double> points, std::size_t joint) {
  const std::size_t n = points.size() / 2 - 1;
  const std::size_t before = joint == 0 ? n - 1 : joint - 1;
  const double ix = points[2 * joint] - points[2 * before];
  const double iy = points[2 * joint + 1] - points[2 * before + 1];
  const double ox = points[2 * joint + 2] - points[2 * joint];
  const double oy = points[2 * joint + 3] - points[2 * joint + 1];
  const double size = std::sqrt((ix * ix + iy * iy) * (ox * ox + oy * oy));
  return size > 0.0 ? 1.0 - (ix * ox + iy * oy) / size : 0.0;
}

std::vector<std::size_t> smooth_joints(const CubicPath& a, const CubicPath& b) {
  std::vector<std::size_t> joints;
  const bool closed = a.is_closed() && b.is_closed();
  for (std::size_t i = closed ? 0 : 3; i + 3 < a.control_points().size(); i += 3) {
    if (direction_break(a.control_points().data(), i) <= kSmooth &&
        direction_break(b.control_points().data(), i) <= kSmooth) {
      joints.push_back(i);
    }
  }
  return joints;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
