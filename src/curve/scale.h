#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "curve/spline.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A power of two that brings the largest coordinate near 1, so that products with binomial coefficients stay
/// in range without rounding; 1 for coordinates of usual size.
[[nodiscard]] inline double power_of_two_scale(std::span<const Curve> curves) {
  double largest = 0.0;
  for (const Curve& curve : curves) {
    for (const double x : curve.control_points().data()) largest = std::max(largest, std::abs(x));
  }
  if (largest == 0.0 || (largest > 1e-100 && largest < 1e100)) return 1.0;
  return std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1020, 1020));
}

/// Scales all but the weights.
inline void scale_coordinates(Spline& spline, double factor) {
  if (factor == 1.0) return;
  const auto stride = static_cast<std::size_t>(spline.stride);
  const std::size_t dim = stride - (spline.rational ? 1 : 0);
  for (std::size_t i = 0; i < spline.size(); ++i) {
    for (std::size_t c = 0; c < dim; ++c) spline[i][c] *= factor;
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
