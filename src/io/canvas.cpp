#include "io/canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr int kLargest = 8192;

int pixels(double length) {
  return std::max(1, static_cast<int>(std::lround(length)));
}

}  // namespace

Canvas canvas_of(const View& view, int size) {
  if (size < 1 || size > kLargest) {
    throw InvalidArgument(fmt::format("picture: the size is {} pixels, expected 1 to {}", size, kLargest));
  }
  const double scale = size / view.size();
  Canvas canvas{pixels(view.width * scale), pixels(view.height * scale), {}};
  const double x = 0.5 * (canvas.width - view.width * scale);
  const double y = 0.5 * (canvas.height - view.height * scale);
  canvas.to_pixels = {scale, 0.0, 0.0, scale, x - view.x * scale, y - view.y * scale};
  return canvas;
}

CubicPath transform(const CubicPath& path, const Transform& map) {
  Points points = path.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto p = points[i];
    const Vec2 mapped = map({p[0], p[1]});
    p[0] = mapped.x;
    p[1] = mapped.y;
  }
  return CubicPath(std::move(points), path.is_closed());
}

}  // namespace v0
}  // namespace tandem
