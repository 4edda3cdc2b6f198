#include <fmt/format.h>
#include <png.h>

#include <array>
#include <cstdint>

#include "io/ink.h"
#include "io/raster.h"
#include "io/svg_parts.h"
#include "tandem/error.h"
#include "tandem/io/picture.h"

namespace tandem {
inline namespace v0 {
namespace {

// A colour per coverage: the ink, ever less transparent.
std::array<std::uint8_t, 1024> ink_by_coverage() {
  std::array<std::uint8_t, 1024> colors{};
  for (std::size_t c = 0; c < 256; ++c) {
    for (std::size_t k = 0; k < 3; ++k) colors[4 * c + k] = kInkColor[k];
    colors[4 * c + 3] = static_cast<std::uint8_t>(c);
  }
  return colors;
}

}  // namespace

std::string format_png(const PathMorph& morph, double s, int size) {
  const std::vector<CubicPath> paths = morph.at(s);
  const View view = view_at(morph, s, paths);
  const Rasterizer rasterizer(canvas_of(view, size), morph.fill_rule(), stroke_width(view));
  const Raster raster = rasterizer.draw(paths);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(raster.width);
  image.height = static_cast<png_uint_32>(raster.height);
  image.format = PNG_FORMAT_RGBA_COLORMAP;
  image.colormap_entries = 256;
  const std::array<std::uint8_t, 1024> colors = ink_by_coverage();
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string content(bytes, '\0');
  if (png_image_write_to_memory(&image, content.data(), &bytes, 0, raster.coverage.data(), raster.width,
                                colors.data()) == 0) {
    throw IoError(fmt::format("png: {}", image.message));
  }
  content.resize(bytes);
  return content;
}

}  // namespace v0
}  // namespace tandem
