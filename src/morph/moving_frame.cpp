#include "tandem/morph/moving_frame.h"

#include <fmt/format.h>

#include <cstddef>
#include <span>
#include <utility>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

void add(Points& points, const Point& offset, double factor) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto p = points[i];
    for (std::size_t c = 0; c < p.size(); ++c) p[c] += factor * offset[c];
  }
}

}  // namespace

MovingFrame::MovingFrame(int dim)
    : first_center_(static_cast<std::size_t>(dim)),
      second_center_(static_cast<std::size_t>(dim)),
      rotation_(dim),
      still_(true) {}

MovingFrame::MovingFrame(Point first_center, Point second_center, Rotation rotation)
    : first_center_(std::move(first_center)),
      second_center_(std::move(second_center)),
      rotation_(std::move(rotation)),
      still_(rotation_.is_identity()) {
  const auto dim = static_cast<std::size_t>(rotation_.dim());
  if (first_center_.size() != dim || second_center_.size() != dim) {
    throw InvalidArgument(
        fmt::format("moving frame: the centres have dimensions {} and {}, expected {} as the rotation",
                    first_center_.size(), second_center_.size(), dim));
  }
}

Points MovingFrame::from_first(Points points) const {
  if (!still_) add(points, first_center_, -1.0);
  return points;
}

Points MovingFrame::from_second(Points points) const {
  if (still_) return points;
  add(points, second_center_, -1.0);
  return rotation_.inverse()(std::move(points));
}

Points MovingFrame::place(Points points, double s) const {
  if (still_) return points;
  Points placed = rotation_.fraction(s)(std::move(points));
  add(placed, first_center_, 1.0 - s);
  add(placed, second_center_, s);
  return placed;
}

Points affine_blend(const MovingFrame& frame, const Points& a, const Points& b, double s) {
  Points points = frame.from_first(a);
  const Points second = frame.from_second(b);
  const std::span<double> blend = points.data();
  const std::span<const double> other = second.data();
  for (std::size_t i = 0; i < blend.size(); ++i) blend[i] = (1.0 - s) * blend[i] + s * other[i];
  return frame.place(std::move(points), s);
}

}  // namespace v0
}  // namespace tandem
