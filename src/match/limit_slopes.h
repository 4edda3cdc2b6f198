#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tandem {
inline namespace v0 {
namespace detail {

/// Slopes that a scalar function may have: 0 < lo <= hi.
struct SlopeRange {
  double lo = 0.0;
  double hi = 0.0;
};

/// Values at increasing x, moved until every slope lies in the range.
///
/// fixed: indices (increasing) whose values stay; the slopes between neighbours among them must lie in the
/// range. The largest movement is the least possible where nothing but the two ends is fixed: half-way
/// between the greatest admissible function below the values and the least one above them.
[[nodiscard]] std::vector<double> limit_slopes(std::span<const double> x, std::span<const double> values,
                                               std::span<const std::size_t> fixed, const SlopeRange& range);

/// The same for values that may lie anywhere in [low, high]: `values` (inside) are kept where the slopes
/// allow, and left within their intervals before they are moved out of them.
[[nodiscard]] std::vector<double> limit_slopes(std::span<const double> x, std::span<const double> values,
                                               std::span<const double> low, std::span<const double> high,
                                               std::span<const std::size_t> fixed, const SlopeRange& range);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
