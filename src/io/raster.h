#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "io/canvas.h"
#include "tandem/io/style.h"
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

/// How lines are drawn. width: in the units of the view.
struct Pen {
  double width = 1.0;
  LineCap cap = LineCap::butt;
  LineJoin join = LineJoin::round;
  double miter_limit = 4.0;
};

/// One picture laid over another: `under` covers at least as much then.
void lay_over(Raster& under, const Raster& over);

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
  /// The inside of all paths together, open ones closed by lines. @throws as draw()
  [[nodiscard]] Raster fill(std::span<const CubicPath> paths) const;
  /// The lines of all paths, open or closed. Open paths that are points draw dots with caps that are not
  /// butt, closed ones nothing. @throws as draw()
  [[nodiscard]] Raster stroke(std::span<const CubicPath> paths, const Pen& pen) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace v0
}  // namespace tandem
