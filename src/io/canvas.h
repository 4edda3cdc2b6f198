#pragma once

#include "io/svg_parts.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {

/// A picture in pixels: its size, and where the view's points fall.
struct Canvas {
  int width = 0;
  int height = 0;
  Transform to_pixels;  ///< the view in the middle, equal scales

  [[nodiscard]] double scale() const noexcept { return to_pixels.a; }
};

/// size: pixels of the longer side. @throws InvalidArgument unless it lies in [1, 8192]
[[nodiscard]] Canvas canvas_of(const View& view, int size);

[[nodiscard]] CubicPath transform(const CubicPath& path, const Transform& map);

}  // namespace v0
}  // namespace tandem
