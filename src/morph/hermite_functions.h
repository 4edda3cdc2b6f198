#pragma once

#include <array>

namespace tandem {
inline namespace v0 {
namespace detail {

/// Velocities at the ends of a step are five-point differences over this share of it: exact to the fourth
/// power of it for what runs as evenly as blends do, and rounding is no more than 1e-12 of the size.
inline constexpr double kDifference = 1e-3;
inline constexpr std::array<double, 5> kStencil = {-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -0.25};

/// The cubic Hermite functions of [0,1] whose velocity is 1 at the start (at the end), and that are nothing
/// else at both ends.
inline double at_start(double x) {
  return x * (1.0 - x) * (1.0 - x);
}
inline double at_end(double x) {
  return -x * x * (1.0 - x);
}

/// The velocity, per unit of s, at a key between two steps that last `first` and `second`: that of the
/// parabola through the three keys, as shares of the velocities per step at the end of the first and at the
/// start of the second one.
struct KeyVelocity {
  KeyVelocity(double first, double second)
      : before(second / (first + second) / first), after(first / (first + second) / second) {}
  double before;
  double after;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
