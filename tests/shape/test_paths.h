#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "tandem/shape/cubic_path.h"
#include "tandem/shape/transform.h"

/// Planar paths to try geometry on.
namespace tandem::test {

inline Vec2 blend(Vec2 a, Vec2 b, double s) {
  return {(1 - s) * a.x + s * b.x, (1 - s) * a.y + s * b.y};
}

inline CubicPath make_path(const std::vector<Vec2>& controls, bool closed) {
  std::vector<double> coords;
  for (const Vec2 p : controls) {
    coords.push_back(p.x);
    coords.push_back(p.y);
  }
  return CubicPath(Points(2, std::move(coords)), closed);
}

inline CubicPath cubic(Vec2 p0, Vec2 p1, Vec2 p2, Vec2 p3) {
  return make_path({p0, p1, p2, p3}, false);
}

/// Lines through the points.
inline CubicPath polyline(const std::vector<Vec2>& points, bool closed = false) {
  std::vector<Vec2> controls{points.front()};
  const std::size_t count = closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 a = points[i];
    const Vec2 b = points[(i + 1) % points.size()];
    controls.insert(controls.end(), {blend(a, b, 1.0 / 3), blend(a, b, 2.0 / 3), b});
  }
  return make_path(controls, closed);
}

inline CubicPath polygon(const std::vector<Vec2>& points) {
  return polyline(points, true);
}

/// Four cubics, within 3e-4 of the radius; counter-clockwise, from (r, 0).
inline CubicPath circle(Vec2 center, double r) {
  constexpr double k = 0.5522847498307936;
  const std::vector<Vec2> unit{{1, 0},   {1, k},   {k, 1},  {0, 1},  {-k, 1}, {-1, k}, {-1, 0},
                               {-1, -k}, {-k, -1}, {0, -1}, {k, -1}, {1, -k}, {1, 0}};
  std::vector<Vec2> controls;
  for (const Vec2 p : unit) controls.push_back({center.x + r * p.x, center.y + r * p.y});
  return make_path(controls, true);
}

inline std::vector<Vec2> controls_of(const CubicPath& path) {
  std::vector<Vec2> controls;
  for (std::size_t i = 0; i < path.control_points().size(); ++i) {
    controls.push_back({path.control_points()[i][0], path.control_points()[i][1]});
  }
  return controls;
}

inline CubicPath reversed(const CubicPath& path) {
  std::vector<Vec2> controls = controls_of(path);
  return make_path({controls.rbegin(), controls.rend()}, path.is_closed());
}

inline Vec2 at(const CubicPath& path, double u) {
  const double i = std::min(std::floor(u), static_cast<double>(path.segment_count() - 1));
  const auto p = path.segment(static_cast<std::size_t>(i));
  const double t = u - i;
  const double s = 1 - t;
  const auto value = [&](std::size_t k) {
    return s * s * s * p[0][k] + 3 * s * t * (s * p[1][k] + t * p[2][k]) + t * t * t * p[3][k];
  };
  return {value(0), value(1)};
}

/// Whether the path runs at less than `angle` (radians) to itself at the two parameters.
inline bool shallow(const CubicPath& path, double u, double v, double angle) {
  const auto direction = [&](double t) {
    const Vec2 p = at(path, t);
    const Vec2 q = at(path, std::min(t + 1e-4, static_cast<double>(path.segment_count())));
    return Vec2{q.x - p.x, q.y - p.y};
  };
  const Vec2 a = direction(u);
  const Vec2 b = direction(v);
  return std::fabs(a.x * b.y - a.y * b.x) <= angle * std::hypot(a.x, a.y) * std::hypot(b.x, b.y);
}

/// A closed path of 1 to 5 cubics with control points anywhere within 10 of the origin.
inline CubicPath any_closed_path() {
  const int k = *rc::gen::inRange(1, 6);
  std::vector<Vec2> controls;
  for (int i = 0; i < 3 * k; ++i) {
    controls.push_back({*rc::gen::inRange(-1000, 1001) / 100.0, *rc::gen::inRange(-1000, 1001) / 100.0});
  }
  controls.push_back(controls.front());
  return make_path(controls, true);
}

}  // namespace tandem::test
