#pragma once

#include <array>
#include <cmath>

namespace tandem {
inline namespace v0 {
namespace detail {

/// A vector of R^3 by value; nothing here guards against overflow: scale first.
using Vector3 = std::array<double, 3>;

[[nodiscard]] inline Vector3 operator-(const Vector3& a, const Vector3& b) noexcept {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

[[nodiscard]] inline Vector3 operator+(const Vector3& a, const Vector3& b) noexcept {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

[[nodiscard]] inline Vector3 operator*(double s, const Vector3& a) noexcept {
  return {s * a[0], s * a[1], s * a[2]};
}

[[nodiscard]] inline double dot(const Vector3& a, const Vector3& b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

[[nodiscard]] inline Vector3 cross(const Vector3& a, const Vector3& b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

[[nodiscard]] inline double length(const Vector3& a) noexcept {
  return std::sqrt(dot(a, a));
}

/// Of length 1; zero stays zero.
[[nodiscard]] inline Vector3 unit(const Vector3& a) noexcept {
  const double l = length(a);
  return l > 0.0 ? (1.0 / l) * a : Vector3{};
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
