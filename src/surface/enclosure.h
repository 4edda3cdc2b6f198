#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem {
inline namespace v0 {
namespace detail {

/// All real numbers from lo to hi. What is computed from enclosures encloses what the same formula gives for
/// any reals out of them, in exact arithmetic: every operation rounds its ends outwards.
///
/// How, without touching the rounding mode of the machine: a rounded result differs from the exact one by at
/// most half a unit in the last place, and down() and up() move it by a whole one or more. A sum is left
/// alone where its rounding error, which TwoSum gives exactly, is zero or points inwards; so differences of
/// nearby numbers, halves, and everything multiplied by an exact zero stay exact. Beyond the range of double
/// the ends become infinite or NaN, and of NaN nothing is proved: no comparison with it is true.
struct Enclosure {
  double lo = 0.0;
  double hi = 0.0;

  constexpr Enclosure() = default;
  constexpr Enclosure(double exactly) : lo(exactly), hi(exactly) {}  // NOLINT: a double is an enclosure
  constexpr Enclosure(double from, double to) : lo(from), hi(to) {}

  [[nodiscard]] constexpr bool is_positive() const noexcept { return lo > 0.0; }
  [[nodiscard]] constexpr bool is_negative() const noexcept { return hi < 0.0; }
  /// Proved to be zero, as opposed to: perhaps zero.
  [[nodiscard]] constexpr bool is_zero() const noexcept { return lo == 0.0 && hi == 0.0; }
  [[nodiscard]] constexpr double middle() const noexcept { return 0.5 * lo + 0.5 * hi; }
};

/// 2^-52: an ulp of x is at most |x| times this, unless x is subnormal, when it is kTiny.
inline constexpr double kUlp = std::numeric_limits<double>::epsilon();
inline constexpr double kTiny = std::numeric_limits<double>::denorm_min();

/// At most the number before x. |x| kUlp + kTiny is at least an ulp of x, so the exact difference is at most
/// x - ulp, which is a double, and rounding is monotone.
inline double down(double x) noexcept {
  return x - (std::abs(x) * kUlp + kTiny);
}
/// At least the number after x.
inline double up(double x) noexcept {
  return x + (std::abs(x) * kUlp + kTiny);
}

/// What a + b, rounded to `sum`, lacks to be exact (Knuth's TwoSum; exact for all doubles unless it
/// overflows).
inline double sum_error(double a, double b, double sum) noexcept {
  const double of_b = sum - a;
  return (a - (sum - of_b)) + (b - of_b);
}

inline double add_down(double a, double b) noexcept {
  const double sum = a + b;
  return sum_error(a, b, sum) >= 0.0 ? sum : down(sum);
}
inline double add_up(double a, double b) noexcept {
  const double sum = a + b;
  return sum_error(a, b, sum) <= 0.0 ? sum : up(sum);
}

inline Enclosure operator+(const Enclosure& a, const Enclosure& b) noexcept {
  return {add_down(a.lo, b.lo), add_up(a.hi, b.hi)};
}
inline Enclosure operator-(const Enclosure& a) noexcept {
  return {-a.hi, -a.lo};
}
inline Enclosure operator-(const Enclosure& a, const Enclosure& b) noexcept {
  return {add_down(a.lo, -b.hi), add_up(a.hi, -b.lo)};
}
inline Enclosure operator*(const Enclosure& a, const Enclosure& b) noexcept {
  if (a.is_zero() || b.is_zero()) return {};
  const double p = a.lo * b.lo;
  const double q = a.lo * b.hi;
  const double r = a.hi * b.lo;
  const double s = a.hi * b.hi;
  // NaN (an infinity times zero) must not be lost in a minimum.
  if (!(p + q + r + s == p + q + r + s)) return {std::nan(""), std::nan("")};
  return {down(std::min(std::min(p, q), std::min(r, s))), up(std::max(std::max(p, q), std::max(r, s)))};
}
/// b must be positive; otherwise nothing is known of the quotient.
inline Enclosure operator/(const Enclosure& a, const Enclosure& b) noexcept {
  if (!b.is_positive()) return {std::nan(""), std::nan("")};
  if (a.is_zero()) return {};
  return {down(a.lo / (a.lo >= 0.0 ? b.hi : b.lo)), up(a.hi / (a.hi >= 0.0 ? b.lo : b.hi))};
}
inline Enclosure& operator+=(Enclosure& a, const Enclosure& b) noexcept {
  return a = a + b;
}

inline Enclosure half(const Enclosure& a) noexcept {
  const double lo = 0.5 * a.lo;
  const double hi = 0.5 * a.hi;
  return {lo + lo == a.lo ? lo : down(lo), hi + hi == a.hi ? hi : up(hi)};
}

/// a times 2^exponent: exact but for what falls into the subnormal numbers.
inline Enclosure scaled(const Enclosure& a, int exponent) noexcept {
  const double lo = std::ldexp(a.lo, exponent);
  const double hi = std::ldexp(a.hi, exponent);
  return {std::ldexp(lo, -exponent) == a.lo ? lo : down(lo), std::ldexp(hi, -exponent) == a.hi ? hi : up(hi)};
}

/// The smallest enclosure of both.
inline Enclosure hull(const Enclosure& a, const Enclosure& b) noexcept {
  const double nan = std::numeric_limits<double>::quiet_NaN();  // which min and max may lose
  return {a.lo < b.lo ? a.lo : (b.lo <= a.lo ? b.lo : nan), a.hi > b.hi ? a.hi : (b.hi >= a.hi ? b.hi : nan)};
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
