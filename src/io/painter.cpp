#include "io/painter.h"

#include <utility>

namespace tandem {
inline namespace v0 {
namespace {

void add(Raster& raster, Raster more) {
  if (raster.coverage.empty()) {
    raster = std::move(more);
  } else {
    lay_over(raster, more);
  }
}

}  // namespace

std::array<double, 4> pixel_of(const Painting& painting, double area, double line) {
  constexpr double kWhite = 255.0;
  const double over = line * painting.line_paint.opacity;
  const double under = area * painting.area_paint.opacity * (1.0 - over);
  std::array<double, 4> pixel{0.0, 0.0, 0.0, over + under};
  if (pixel[3] == 0.0) return pixel;
  const std::array<double, 3> above = rgb_of(painting.line_paint);
  const std::array<double, 3> below = rgb_of(painting.area_paint);
  for (std::size_t k = 0; k < 3; ++k) pixel[k] = (over * above[k] + under * below[k]) / (pixel[3] * kWhite);
  return pixel;
}

Painter::Painter(const PathMorph& morph, const Look& look, const View& view, const Canvas& canvas)
    : key_times_(morph.key_times()),
      layers_(layers_of(morph, look, view, ink_paint())),
      canvas_(canvas),
      rasterizer_(canvas, morph.fill_rule(), stroke_width(view)) {}

Painting Painter::draw(double s, const std::vector<CubicPath>& paths) const {
  Painting painting;
  for (const Layer& layer : layers_) {
    const Style style = style_at(layer, key_times_, s);
    const std::vector<CubicPath> part = part_of(layer, paths);
    if (layer.fills()) {
      painting.area_paint = style.fill;
      add(painting.area, rasterizer_.fill(part));
    }
    if (layer.strokes()) {
      painting.line_paint = style.stroke;
      add(painting.line,
          rasterizer_.stroke(part, {style.stroke_width, style.line_cap, style.line_join, style.miter_limit}));
    }
  }
  if (painting.area.coverage.empty()) {
    painting.area_paint = painting.line_paint;
    std::swap(painting.area, painting.line);
  }
  const bool same = rgb_of(painting.area_paint) == rgb_of(painting.line_paint) &&
                    painting.area_paint.opacity == 1.0 && painting.line_paint.opacity == 1.0;
  if (painting.two_paints() && same) {
    lay_over(painting.area, painting.line);
    painting.line = {};
  }
  if (painting.area.coverage.empty()) {  // nothing is painted
    painting.area = {canvas_.width, canvas_.height, {}};
    painting.area.coverage.resize(static_cast<std::size_t>(canvas_.width) *
                                  static_cast<std::size_t>(canvas_.height));
  }
  return painting;
}

}  // namespace v0
}  // namespace tandem
