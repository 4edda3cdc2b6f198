#pragma once

#include <span>

#include "tandem/curve/curve.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// A point or vector of the plane.
struct Vec2 {
  double x = 0.0;
  double y = 0.0;
  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

/// A planar affine map: (x, y) -> (a x + c y + e, b x + d y + f), SVG's matrix(a b c d e f).
struct TANDEM_EXPORT Transform {
  double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;

  [[nodiscard]] Vec2 operator()(Vec2 p) const noexcept {
    return {a * p.x + c * p.y + e, b * p.x + d * p.y + f};
  }
  /// this after inner: (outer * inner)(p) = outer(inner(p)).
  [[nodiscard]] Transform operator*(const Transform& inner) const noexcept;

  [[nodiscard]] static Transform translate(double x, double y) noexcept { return {1, 0, 0, 1, x, y}; }
  [[nodiscard]] static Transform scale(double x, double y) noexcept { return {x, 0, 0, y, 0, 0}; }
  /// Counter-clockwise in a system with y up (clockwise on a screen); our own sine and cosine, so that
  /// results agree on every platform.
  [[nodiscard]] static Transform rotate_degrees(double angle) noexcept;
  [[nodiscard]] static Transform skew_x_degrees(double angle) noexcept;
  [[nodiscard]] static Transform skew_y_degrees(double angle) noexcept;

  friend constexpr bool operator==(const Transform&, const Transform&) = default;
};

/// The planar curve with its control points mapped. @throws InvalidArgument dim != 2
[[nodiscard]] TANDEM_EXPORT Curve transform(const Curve& curve, const Transform& map);

}  // namespace v0
}  // namespace tandem
