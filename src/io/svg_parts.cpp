#include "io/svg_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/ink.h"
#include "io/number.h"
#include "tandem/io/path_data.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr double kMargin = 0.05;        // of the larger side
constexpr double kStrokeWidth = 0.012;  // of the larger side
constexpr double kRelativeUnit = 1e-5;  // last decimal, as a share of the size
constexpr int kMostDecimals = 20;

}  // namespace

View view_of(const Box& box) {
  if (box.empty()) return {};
  const double width = box.hi[0] - box.lo[0];
  const double height = box.hi[1] - box.lo[1];
  const double size = std::max(width, height);
  const double margin = size > 0.0 ? kMargin * size : 0.5;
  return {box.lo[0] - margin, box.lo[1] - margin, width + 2.0 * margin, height + 2.0 * margin};
}

int decimals_for(double size) {
  const double decimals = std::ceil(-std::log10(size * kRelativeUnit));
  if (!(decimals <= kMostDecimals)) return -1;
  return static_cast<int>(std::max(decimals, 0.0));
}

int decimals_for(const View& view, int precision) {
  return precision >= 0 ? precision : decimals_for(view.size());
}

std::string format_view_box(const View& view) {
  const int precision = decimals_for(view.size());
  return fmt::format("{} {} {} {}", format_number(view.x, precision), format_number(view.y, precision),
                     format_number(view.width, precision), format_number(view.height, precision));
}

PathDataParts path_data_parts(std::span<const CubicPath> paths, std::span<const std::vector<bool>> lines,
                              int precision) {
  PathDataParts parts;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    std::string& text = paths[i].is_closed() ? parts.filled : parts.stroked;
    text += format_path_data(paths.subspan(i, 1), i < lines.size() ? lines.subspan(i, 1) : lines.first(0),
                             precision);
  }
  return parts;
}

double stroke_width(const View& view) {
  return kStrokeWidth * view.size();
}

std::string fill_attributes(FillRule fill_rule) {
  return fmt::format("fill=\"{}\"{}", kInk, fill_rule == FillRule::evenodd ? " fill-rule=\"evenodd\"" : "");
}

std::string stroke_attributes(const View& view) {
  return "fill=\"none\" " + line_attributes(view);
}

std::string line_attributes(const View& view) {
  // Butt caps: a contour that has shrunk to a point draws nothing.
  return fmt::format("stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"butt\" stroke-linejoin=\"round\"",
                     kInk, format_number(stroke_width(view), decimals_for(view.size())));
}

}  // namespace v0
}  // namespace tandem
