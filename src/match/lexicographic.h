#pragma once

#include <limits>

namespace tandem {
inline namespace v0 {

/// A cost in the programmes' order: first the invalidity (a whole number, exact in a double), then the cost.
struct LexCost {
  double invalid = 0.0;
  double cost = 0.0;

  [[nodiscard]] static constexpr LexCost infinite() noexcept {
    return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  friend constexpr bool operator<(const LexCost& x, const LexCost& y) noexcept {
    return x.invalid < y.invalid || (x.invalid == y.invalid && x.cost < y.cost);
  }
  friend constexpr bool operator==(const LexCost&, const LexCost&) = default;
};

/// Aggregate::sum: costs of a path add up.
struct SumCosts {
  [[nodiscard]] static constexpr double join(double path, double next) noexcept { return path + next; }
};

/// Aggregate::maximum: the largest cost counts.
struct MaxCosts {
  [[nodiscard]] static constexpr double join(double path, double next) noexcept {
    return path < next ? next : path;
  }
};

}  // namespace v0
}  // namespace tandem
