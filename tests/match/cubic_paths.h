#pragma once

#include <cmath>
#include <random>
#include <utility>

#include "tandem/curve/edit.h"
#include "tandem/shape/cubic_path.h"

/// Random cubic paths, and what tests of the segments method do with them.
namespace tandem::cubics {

inline CubicPath random_path(std::mt19937& random, int dim, std::size_t segments, bool closed) {
  std::normal_distribution<double> number(0.0, 1.0);
  Points points(dim, 3 * segments + 1);
  for (double& x : points.data()) x = number(random);
  if (closed) {
    const std::size_t last = points.size() - 1;
    for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) points[last][d] = points[0][d];
  }
  return CubicPath(std::move(points), closed);
}

/// A loop that is smooth at every joint.
inline CubicPath smooth_loop(std::mt19937& random, int dim, std::size_t segments) {
  std::normal_distribution<double> number(0.0, 1.0);
  std::uniform_real_distribution<double> length(0.2, 1.0);
  CubicPath path = random_path(random, dim, segments, true);
  Points points = path.control_points();
  for (std::size_t j = 0; j < segments; ++j) {
    Point tangent(static_cast<std::size_t>(dim));
    for (double& x : tangent) x = number(random);
    const double before = length(random);
    const double after = length(random);
    const std::size_t in = j == 0 ? 3 * segments - 1 : 3 * j - 1;
    for (std::size_t d = 0; d < tangent.size(); ++d) {
      points[in][d] = points[3 * j][d] - before * tangent[d];
      points[3 * j + 1][d] = points[3 * j][d] + after * tangent[d];
    }
  }
  return CubicPath(std::move(points), true);
}

/// The loop from joint `first` on.
inline CubicPath from_joint(const CubicPath& loop, std::size_t first) {
  const std::size_t n = 3 * loop.segment_count();
  Points points(loop.dim(), n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    const auto p = loop.control_points()[(3 * first + i) % n];
    std::copy(p.begin(), p.end(), points[i].begin());
  }
  return CubicPath(std::move(points), true);
}

inline CubicPath backwards(const CubicPath& path) {
  const Points& from = path.control_points();
  Points points;
  for (std::size_t i = from.size(); i-- > 0;) points.push_back(from[i]);
  return CubicPath(std::move(points), path.is_closed());
}

inline CubicPath moved(const CubicPath& path, double by) {
  Points points = path.control_points();
  for (double& x : points.data()) x += by;
  return CubicPath(std::move(points), path.is_closed());
}

inline double largest_difference(const CubicPath& a, const CubicPath& b) {
  if (a.control_points().size() != b.control_points().size()) return INFINITY;
  double most = 0.0;
  for (std::size_t k = 0; k < a.control_points().data().size(); ++k) {
    most = std::max(most, std::fabs(a.control_points().data()[k] - b.control_points().data()[k]));
  }
  return most;
}

}  // namespace tandem::cubics
