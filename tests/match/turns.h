#pragma once

#include <random>
#include <vector>

#include "match/nearest_rotation.h"
#include "match/random_curves.h"
#include "tandem/curve/curve.h"
#include "tandem/match/rotation.h"

namespace tandem::testing_curves {

inline Rotation random_rotation(std::mt19937& random, int dim) {
  std::vector<double> numbers(static_cast<std::size_t>(dim) * static_cast<std::size_t>(dim));
  for (double& x : numbers) x = uniform(random, -1.0, 1.0);
  return detail::nearest_rotation(numbers, dim).rotation;
}

/// R S
inline Rotation product(const Rotation& r, const Rotation& s) {
  const auto n = static_cast<std::size_t>(r.dim());
  Points columns(r.dim(), n);
  for (std::size_t k = 0; k < n; ++k) columns[k][k] = 1.0;
  columns = r(s(columns));
  if (r.dim() == 2) return Rotation(2, columns[0]);
  std::vector<double> values(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) values[i * n + k] = columns[k][i];
  }
  return Rotation(r.dim(), values);
}

/// The curve turned about the origin and scaled.
inline Curve turned(const Curve& curve, const Rotation& rotation, double scale = 1.0) {
  Points points = rotation(curve.control_points());
  for (double& x : points.data()) x *= scale;
  return Curve(curve.degree(), curve.knots(), std::move(points), curve.weights());
}

}  // namespace tandem::testing_curves
