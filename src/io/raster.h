#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "io/canvas.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/shape.h"

namespace tandem {
inline namespace v0 {

/// How much of each pixel is covered, 0 to 255, row by row from the top.
struct Raster {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> coverage;
};

/// Draws paths with FreeType's smooth rasteriser, which computes the area covered of each pixel.
class Rasterizer {
 public:
  /// line_width: of open paths, in the units of the view.
  Rasterizer(const Canvas& canvas, FillRule fill_rule, double line_width);
  Rasterizer(Rasterizer&&) noexcept;
  Rasterizer& operator=(Rasterizer&&) noexcept;
  ~Rasterizer();

  /// Closed paths together filled by the rule, open ones stroked (butt caps, round joins); planar.
  /// @throws InvalidArgument more than 32,767 control points, more than FreeType takes
  [[nodiscard]] Raster draw(std::span<const CubicPath> paths) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace v0
}  // namespace tandem
