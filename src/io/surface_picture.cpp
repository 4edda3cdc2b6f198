#include "tandem/io/surface_picture.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "io/base64.h"
#include "io/camera.h"
#include "io/faces.h"
#include "io/ink.h"
#include "io/number.h"
#include "io/raster.h"
#include "io/scene_ball.h"
#include "io/visible_lines.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::PixelLine;

constexpr int kLargest = 8192;

/// How lines of a kind are drawn: width as a share of the longer side.
struct Style {
  double width;
  double opacity;
  double slack;  ///< detail::visible_parts()
};
constexpr Style kIso{1.0 / 1024, 0.4, 0.012};
constexpr Style kEdge{1.8 / 1024, 0.9, 0.014};
constexpr Style kCurve{3.6 / 1024, 1.0, 0.02};

/// A picture: faces, and the visible lines by their kind.
struct Drawing {
  struct Layer {
    std::vector<PixelLine> lines;
    double width;
    double opacity;
  };
  int width;
  int height;
  std::vector<std::uint8_t> colors;
  std::array<Layer, 3> layers;
};

Drawing draw(const Scene& scene, int size) {
  if (size < 1 || size > kLargest) {
    throw InvalidArgument(fmt::format("picture: the size is {} pixels, expected 1 to {}", size, kLargest));
  }
  detail::check_scene(scene);
  const detail::Camera camera(scene);
  const detail::Faces faces(scene, camera, size);
  const auto layer = [&](const std::vector<Points>& lines, const Style& style) {
    return Drawing::Layer{detail::visible_parts(lines, camera, faces, style.slack), style.width * size,
                          style.opacity};
  };
  return {faces.width(),
          faces.height(),
          faces.colors(),
          {layer(scene.iso_lines, kIso), layer(scene.edges, kEdge), layer(scene.curves, kCurve)}};
}

std::string encode_png(int width, int height, const std::vector<std::uint8_t>& colors) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGBA;
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string content(bytes, '\0');
  if (png_image_write_to_memory(&image, content.data(), &bytes, 0, colors.data(), 4 * width, nullptr) == 0) {
    throw IoError(fmt::format("png: {}", image.message));
  }
  content.resize(bytes);
  return content;
}

/// Straight segments as cubics.
CubicPath to_path(const PixelLine& line) {
  Points points(2, 3 * (line.size() - 1) + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t k = std::min(i / 3, line.size() - 2);
    const double t = static_cast<double>(i - 3 * k) / 3.0;
    for (std::size_t c = 0; c < 2; ++c) points[i][c] = (1.0 - t) * line[k][c] + t * line[k + 1][c];
  }
  return CubicPath(std::move(points), false);
}

/// Ink over what is there, as much as is covered.
void lay_over(std::vector<std::uint8_t>& colors, const Raster& raster, double opacity) {
  for (std::size_t i = 0; i < raster.coverage.size(); ++i) {
    const double over = opacity * raster.coverage[i] / 255.0;
    if (!(over > 0.0)) continue;
    std::uint8_t* pixel = colors.data() + 4 * i;
    const double under = (1.0 - over) * pixel[3] / 255.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double mixed = (over * kInkColor[c] + under * pixel[c]) / (over + under);
      pixel[c] = static_cast<std::uint8_t>(std::lround(mixed));
    }
    pixel[3] = static_cast<std::uint8_t>(std::lround(255.0 * (over + under)));
  }
}

std::string path_data(const std::vector<PixelLine>& lines) {
  constexpr int kDecimals = 1;
  std::string text;
  for (const PixelLine& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      text += i == 0 ? "M" : i == 1 ? "L" : " ";
      append_number(text, line[i][0], kDecimals);
      text += ' ';
      append_number(text, line[i][1], kDecimals);
    }
  }
  return text;
}

}  // namespace

std::string format_scene_svg(const Scene& scene, int size) {
  const Drawing drawing = draw(scene, size);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
      "<image width=\"{0}\" height=\"{1}\" href=\"data:image/png;base64,{2}\"/>\n"
      "<g fill=\"none\" stroke=\"{3}\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n",
      drawing.width, drawing.height, to_base64(encode_png(drawing.width, drawing.height, drawing.colors)),
      kInk);
  constexpr std::array<const char*, 3> kClasses = {"iso", "edge", "curve"};
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
    const Drawing::Layer& layer = drawing.layers[i];
    if (layer.lines.empty()) continue;
    text +=
        fmt::format("<path class=\"{}\" stroke-width=\"{}\" stroke-opacity=\"{}\" d=\"{}\"/>\n", kClasses[i],
                    format_number(layer.width, 3), format_number(layer.opacity, 2), path_data(layer.lines));
  }
  return text + "</g>\n</svg>\n";
}

std::string format_scene_png(const Scene& scene, int size) {
  Drawing drawing = draw(scene, size);
  const Canvas canvas{drawing.width, drawing.height, {}};
  for (const Drawing::Layer& layer : drawing.layers) {
    if (layer.lines.empty()) continue;
    std::vector<CubicPath> paths;
    for (const PixelLine& line : layer.lines) paths.push_back(to_path(line));
    const Rasterizer rasterizer(canvas, FillRule::nonzero, layer.width);
    lay_over(drawing.colors, rasterizer.draw(paths), layer.opacity);
  }
  return encode_png(drawing.width, drawing.height, drawing.colors);
}

}  // namespace v0
}  // namespace tandem
