#include "morph/planar_frame.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "shape/trigonometry.h"

namespace tandem {
inline namespace v0 {
namespace detail {

PlanarFrame::PlanarFrame(Vec2 first_center, Vec2 second_center, double degrees, double scale)
    : first_center_(first_center), second_center_(second_center), degrees_(degrees), scale_(scale) {}

Transform PlanarFrame::placement(double s) const {
  if (stands_still()) return {};
  const CosSin turn = cos_sin_degrees(s * degrees_);
  const double size = scale_ == 1.0 ? 1.0 : std::exp(s * std::log(scale_));
  Transform map{size * turn.cosine, size * turn.sine, -size * turn.sine, size * turn.cosine, 0.0, 0.0};
  const Vec2 from = map(first_center_);
  map.e = (1.0 - s) * first_center_.x + s * second_center_.x - from.x;
  map.f = (1.0 - s) * first_center_.y + s * second_center_.y - from.y;
  return map;
}

CubicPath PlanarFrame::from_second(const CubicPath& path) const {
  if (stands_still()) return path;
  const CosSin back = cos_sin_degrees(-degrees_);
  const double c = back.cosine / scale_;
  const double d = back.sine / scale_;
  Points points = path.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto p = points[i];
    const double x = p[0] - second_center_.x;
    const double y = p[1] - second_center_.y;
    p[0] = c * x - d * y + first_center_.x;
    p[1] = d * x + c * y + first_center_.y;
  }
  return CubicPath(std::move(points), path.is_closed());
}

void PlanarFrame::place(double s, std::span<double> points) const {
  if (stands_still()) return;
  const Transform map = placement(s);
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
    const Vec2 placed = map({points[i], points[i + 1]});
    points[i] = placed.x;
    points[i + 1] = placed.y;
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
