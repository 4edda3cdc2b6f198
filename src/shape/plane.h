#pragma once

#include <cmath>

#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {

// Arithmetic of planar vectors of moderate size: nothing here guards against overflow.

[[nodiscard]] inline Vec2 plus(Vec2 a, Vec2 b) {
  return {a.x + b.x, a.y + b.y};
}
[[nodiscard]] inline Vec2 minus(Vec2 a, Vec2 b) {
  return {a.x - b.x, a.y - b.y};
}
[[nodiscard]] inline Vec2 times(double s, Vec2 a) {
  return {s * a.x, s * a.y};
}
[[nodiscard]] inline double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
/// Positive when b points to the left of a.
[[nodiscard]] inline double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}
[[nodiscard]] inline double length(Vec2 a) {
  return std::sqrt(dot(a, a));
}
[[nodiscard]] inline Vec2 middle(Vec2 a, Vec2 b) {
  return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
}
[[nodiscard]] inline double distance(Vec2 a, Vec2 b) {
  return length(minus(a, b));
}

/// What a cubic sweeps over as seen from the origin, counter-clockwise positive (Green's theorem).
[[nodiscard]] inline double swept_area(Vec2 p0, Vec2 p1, Vec2 p2, Vec2 p3) {
  return (6.0 * cross(p0, p1) + 3.0 * cross(p0, p2) + cross(p0, p3) + 3.0 * cross(p1, p2) +
          3.0 * cross(p1, p3) + 6.0 * cross(p2, p3)) /
         20.0;
}

}  // namespace v0
}  // namespace tandem
