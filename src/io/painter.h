#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "io/layers.h"
#include "io/raster.h"

namespace tandem {
inline namespace v0 {

/// A picture in at most two paints, one over the other.
struct Painting {
  Raster area;
  Raster line;  ///< over `area`; without pixels when there is but one paint
  Paint area_paint;
  Paint line_paint;

  [[nodiscard]] bool two_paints() const { return !line.coverage.empty(); }
};

/// Red, green, blue and opacity, 0 to 1 each, of a pixel that both paints cover to these shares.
[[nodiscard]] std::array<double, 4> pixel_of(const Painting& painting, double area, double line);

/// Draws in-betweens in the colours of their look. What has no colour of its own is black.
class Painter {
 public:
  Painter(const PathMorph& morph, const Look& look, const View& view, const Canvas& canvas);

  /// paths: morph.at(s). @throws InvalidArgument as Rasterizer
  [[nodiscard]] Painting draw(double s, const std::vector<CubicPath>& paths) const;

 private:
  std::vector<double> key_times_;
  std::vector<Layer> layers_;
  Canvas canvas_;
  Rasterizer rasterizer_;
};

}  // namespace v0
}  // namespace tandem
