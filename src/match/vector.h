#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace tandem {
inline namespace v0 {
namespace detail {

[[nodiscard]] inline double dot(std::span<const double> x, std::span<const double> y) noexcept {
  double sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += x[k] * y[k];
  return sum;
}

[[nodiscard]] inline double cross(std::span<const double> x, std::span<const double> y) noexcept {
  return x[0] * y[1] - x[1] * y[0];
}

/// The largest |coordinate|.
[[nodiscard]] inline double largest(std::span<const double> x) noexcept {
  double most = 0.0;
  for (double c : x) most = std::max(most, std::fabs(c));
  return most;
}

/// Scales x to length 1 and returns the length it had; scaled before squared, so nothing over- or underflows.
/// A vector of no length stays zero.
inline double normalize(std::span<double> x) noexcept {
  const double most = largest(x);
  if (!(most > 0.0) || most > 1.7976931348623157e308) {
    std::fill(x.begin(), x.end(), 0.0);
    return 0.0;
  }
  // 1 / most itself would overflow for subnormal coordinates.
  for (double& c : x) c /= most;
  const double length = std::sqrt(dot(x, x));
  for (double& c : x) c /= length;
  return length * most;
}

/// |x - y| without over- or underflow.
[[nodiscard]] inline double distance(std::span<const double> x, std::span<const double> y) noexcept {
  double most = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) most = std::max(most, std::fabs(x[k] - y[k]));
  if (!(most > 0.0)) return 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double d = (x[k] - y[k]) / most;
    sum += d * d;
  }
  return most * std::sqrt(sum);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
