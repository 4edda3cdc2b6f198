#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace tandem {
inline namespace v0 {
namespace detail {

/// Euclidean length of v, scaled so that no square overflows or vanishes.
[[nodiscard]] inline double scaled_norm(std::span<const double> v) {
  double largest = 0.0;
  for (const double x : v) largest = std::max(largest, std::abs(x));
  if (largest == 0.0) return 0.0;
  double sum = 0.0;
  for (const double x : v) sum += (x / largest) * (x / largest);
  return largest * std::sqrt(sum);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
