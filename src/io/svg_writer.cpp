#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "io/layers.h"
#include "io/style_properties.h"
#include "io/svg_parts.h"
#include "tandem/error.h"
#include "tandem/io/path_data.h"
#include "tandem/io/svg.h"

namespace tandem {
inline namespace v0 {
namespace {

// Curves that are no cubics are drawn within this share of the picture's diagonal.
constexpr double kTolerance = 1e-6;

constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";

std::string document(const View& view, const PathDataParts& parts, FillRule fill_rule) {
  std::string text =
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{}\">\n", format_view_box(view));
  if (!parts.filled.empty())
    text += fmt::format("<path {} d=\"{}\"/>\n", fill_attributes(fill_rule), parts.filled);
  if (!parts.stroked.empty())
    text += fmt::format("<path {} d=\"{}\"/>\n", stroke_attributes(view), parts.stroked);
  return text + "</svg>\n";
}

}  // namespace

std::string format_svg(const Shape& shape) {
  if (!shape.contours.empty() && shape.dim() != 2) {
    throw InvalidArgument(fmt::format("svg: the shape has dimension {}, expected 2", shape.dim()));
  }
  const Box box = bounding_box(shape);
  const double tolerance = std::max(kTolerance * box.diagonal(), std::numeric_limits<double>::min());
  std::vector<CubicPath> paths;
  std::vector<std::vector<bool>> lines;
  for (const Curve& curve : shape.contours) {
    paths.push_back(to_cubic_path(curve, tolerance));
    std::vector<bool>& straight = lines.emplace_back();
    for (std::size_t k = 0; k < paths.back().segment_count(); ++k) {
      straight.push_back(paths.back().is_line(k, 0.0));
    }
  }
  return document(view_of(box), path_data_parts(paths, lines, -1), shape.fill_rule);
}

std::string format_frame_svg(const PathMorph& morph, double s, int precision, const Look& look) {
  const std::vector<CubicPath> paths = morph.at(s);
  const View view = view_at(morph, look, s, paths);
  std::vector<std::vector<bool>> lines;
  for (const PathContour& contour : morph.contours()) lines.push_back(contour.lines);
  std::string text =
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{}\">\n", format_view_box(view));
  for (const Layer& layer : layers_of(morph, look, view, ink_paint())) {
    const Style style = style_at(layer, morph.key_times(), s);
    text += fmt::format(
        "<path {}d=\"{}\"/>\n", attributes_text(style, morph.fill_rule(), decimals_for(view.size())),
        format_path_data(part_of(layer, paths), part_of(layer, lines), decimals_for(view, precision)));
  }
  return text + "</svg>\n";
}

std::string format_keys_svg(const PathMorph& morph, int precision) {
  const View view = view_of(morph.box());
  const auto any = [&](bool closed) {
    return std::any_of(morph.contours().begin(), morph.contours().end(),
                       [&](const PathContour& c) { return c.keys.front().is_closed() == closed; });
  };
  // One element per key: where some contours are open, the closed ones are stroked with them.
  std::string paint = any(true) ? fill_attributes(morph.fill_rule()) : "fill=\"none\"";
  if (any(false)) paint += ' ' + line_attributes(view);
  std::string text =
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{}\">\n", format_view_box(view));
  const std::vector<std::string> keys = format_key_paths(morph, precision);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string id = i < kLetters.size() ? fmt::format(" id=\"{}\"", kLetters[i]) : std::string();
    text += fmt::format("<path{} {} opacity=\"0.5\" d=\"{}\"/>\n", id, paint, keys[i]);
  }
  return text + "</svg>\n";
}

}  // namespace v0
}  // namespace tandem
