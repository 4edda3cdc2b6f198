#pragma once

#include <cstddef>
#include <vector>

#include "tandem/curve/curve.h"

namespace tandem::testing {

/// De Boor's algorithm in long double on the span that holds t (the last one that does): an oracle that
/// shares neither code nor rounding with the library.
inline std::vector<long double> reference_point(const Curve& curve, long double t) {
  const auto p = static_cast<std::size_t>(curve.degree());
  const auto dim = static_cast<std::size_t>(curve.dim());
  const std::vector<double>& knots = curve.knots();
  std::size_t k = p;
  while (k + 1 < curve.size() && (static_cast<long double>(knots[k + 1]) <= t || knots[k + 1] == knots[k]))
    ++k;
  while (knots[k] == knots[k + 1]) --k;
  std::vector<std::vector<long double>> d(p + 1, std::vector<long double>(dim + 1));
  for (std::size_t j = 0; j <= p; ++j) {
    const std::size_t i = k - p + j;
    const long double w = curve.is_rational() ? curve.weights()[i] : 1.0L;
    for (std::size_t c = 0; c < dim; ++c) d[j][c] = w * curve.control_points()[i][c];
    d[j][dim] = w;
  }
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t j = p; j >= r; --j) {
      const std::size_t i = k - p + j;
      const long double lo = knots[i];
      const long double hi = knots[i + p + 1 - r];
      const long double a = (t - lo) / (hi - lo);
      for (std::size_t c = 0; c <= dim; ++c) d[j][c] = (1.0L - a) * d[j - 1][c] + a * d[j][c];
    }
  }
  std::vector<long double> point(dim);
  for (std::size_t c = 0; c < dim; ++c) point[c] = d[p][c] / d[p][dim];
  return point;
}

}  // namespace tandem::testing
