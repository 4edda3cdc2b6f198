#include "tandem/shape/transform.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "shape/trigonometry.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

Transform Transform::operator*(const Transform& inner) const noexcept {
  return {a * inner.a + c * inner.b, b * inner.a + d * inner.b,     a * inner.c + c * inner.d,
          b * inner.c + d * inner.d, a * inner.e + c * inner.f + e, b * inner.e + d * inner.f + f};
}

Transform Transform::rotate_degrees(double angle) noexcept {
  const CosSin t = cos_sin_degrees(angle);
  return {t.cosine, t.sine, -t.sine + 0.0, t.cosine, 0.0, 0.0};
}

Transform Transform::skew_x_degrees(double angle) noexcept {
  const CosSin t = cos_sin_degrees(angle);
  return {1.0, 0.0, t.sine / t.cosine, 1.0, 0.0, 0.0};
}

Transform Transform::skew_y_degrees(double angle) noexcept {
  const CosSin t = cos_sin_degrees(angle);
  return {1.0, t.sine / t.cosine, 0.0, 1.0, 0.0, 0.0};
}

Curve transform(const Curve& curve, const Transform& map) {
  if (curve.dim() != 2) {
    throw InvalidArgument(fmt::format("transform: the curve has dimension {}, expected 2", curve.dim()));
  }
  Points points = curve.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 p = map(Vec2{points[i][0], points[i][1]});
    points[i][0] = p.x;
    points[i][1] = p.y;
  }
  return Curve(curve.degree(), curve.knots(), std::move(points), curve.weights());
}

}  // namespace v0
}  // namespace tandem
