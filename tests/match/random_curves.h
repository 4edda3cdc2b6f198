#pragma once

#include <random>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/curve/edit.h"

namespace tandem::testing_curves {

inline double uniform(std::mt19937& random, double lo, double hi) {
  return lo + (hi - lo) * (static_cast<double>(random()) / 4294967296.0);
}

/// A smooth open B-spline that wanders to the right; cubic, 6 to 12 control points.
inline Curve open_curve(std::mt19937& random, int dim = 2) {
  const std::size_t n = 6 + random() % 7;
  Points points(dim, n);
  for (std::size_t i = 0; i < n; ++i) {
    points[i][0] = static_cast<double>(i) + uniform(random, -0.8, 0.8);
    for (int c = 1; c < dim; ++c) points[i][static_cast<std::size_t>(c)] = uniform(random, -2.0, 2.0);
  }
  return Curve::clamped_uniform(3, std::move(points));
}

/// A smooth closed B-spline round the origin, star-shaped, run through counter-clockwise: periodic, cubic.
inline Curve closed_curve(std::mt19937& random) {
  const std::size_t n = 6 + random() % 6;
  Points points(2, 0);
  for (std::size_t i = 0; i < n + 3; ++i) {
    if (i >= n) {
      const std::vector<double> again(points[i - n].begin(), points[i - n].end());
      points.push_back(again);
      continue;
    }
    const double angle =
        6.283185307179586 * (static_cast<double>(i) + uniform(random, -0.3, 0.3)) / static_cast<double>(n);
    const double radius = uniform(random, 0.5, 2.0);
    points.push_back(std::vector<double>{radius * std::cos(angle), radius * std::sin(angle)});
  }
  std::vector<double> knots;
  for (std::size_t k = 0; k < n + 3 + 4; ++k)
    knots.push_back((static_cast<double>(k) - 3.0) / static_cast<double>(n));
  return Curve(3, std::move(knots), std::move(points));
}

/// The curve moved by (x, y, ...).
inline Curve moved(const Curve& curve, const std::vector<double>& by) {
  Points points = curve.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t c = 0; c < by.size(); ++c) points[i][c] += by[c];
  }
  return Curve(curve.degree(), curve.knots(), std::move(points), curve.weights());
}

}  // namespace tandem::testing_curves
