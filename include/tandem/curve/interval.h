#pragma once

namespace tandem {
inline namespace v0 {

/// A closed interval [lo, hi] of a parameter.
struct Interval {
  double lo = 0.0;
  double hi = 1.0;

  [[nodiscard]] constexpr double length() const noexcept { return hi - lo; }
  [[nodiscard]] constexpr bool contains(double t) const noexcept { return lo <= t && t <= hi; }
  [[nodiscard]] constexpr double clamp(double t) const noexcept { return t < lo ? lo : (t > hi ? hi : t); }
  friend constexpr bool operator==(const Interval&, const Interval&) = default;
};

}  // namespace v0
}  // namespace tandem
