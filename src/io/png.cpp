#include <fmt/format.h>
#include <png.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "io/painter.h"
#include "tandem/error.h"
#include "tandem/io/picture.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr double kWhite = 255.0;

void append_pixel(std::vector<std::uint8_t>& bytes, const std::array<double, 4>& pixel) {
  for (const double x : pixel) bytes.push_back(static_cast<std::uint8_t>(std::lround(kWhite * x)));
}

std::string written(png_image& image, const std::vector<std::uint8_t>& pixels, int row,
                    const std::vector<std::uint8_t>& colors) {
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string content(bytes, '\0');
  if (png_image_write_to_memory(&image, content.data(), &bytes, 0, pixels.data(), row,
                                colors.empty() ? nullptr : colors.data()) == 0) {
    throw IoError(fmt::format("png: {}", image.message));
  }
  content.resize(bytes);
  return content;
}

}  // namespace

std::string format_png(const PathMorph& morph, double s, int size, const Look& look) {
  const std::vector<CubicPath> paths = morph.at(s);
  const View view = view_at(morph, look, s, paths);
  const Painting painting = Painter(morph, look, view, canvas_of(view, size)).draw(s, paths);
  const Raster& area = painting.area;
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(area.width);
  image.height = static_cast<png_uint_32>(area.height);
  std::vector<std::uint8_t> bytes;
  if (!painting.two_paints()) {
    // A colour per coverage: the paint, ever less transparent.
    image.format = PNG_FORMAT_RGBA_COLORMAP;
    image.colormap_entries = 256;
    const std::array<double, 3> rgb = rgb_of(painting.area_paint);
    for (int c = 0; c < 256; ++c) {
      append_pixel(bytes, {rgb[0] / kWhite, rgb[1] / kWhite, rgb[2] / kWhite,
                           c / kWhite * painting.area_paint.opacity});
    }
    return written(image, area.coverage, area.width, bytes);
  }
  image.format = PNG_FORMAT_RGBA;
  bytes.reserve(4 * area.coverage.size());
  for (std::size_t i = 0; i < area.coverage.size(); ++i) {
    append_pixel(bytes, pixel_of(painting, area.coverage[i] / kWhite, painting.line.coverage[i] / kWhite));
  }
  return written(image, bytes, 4 * area.width, {});
}

}  // namespace v0
}  // namespace tandem
