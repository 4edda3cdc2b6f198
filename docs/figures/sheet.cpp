#include "sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "tandem/curve/compatible.h"
#include "tandem/curve/edit.h"
#include "tandem/io/path_data.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/transform.h"

namespace tandem::figures {

namespace {

constexpr double kMargin = 12.0;
constexpr double kLabelHeight = 22.0;

std::string path_of(const Shape& shape, const Transform& place) {
  std::vector<CubicPath> paths;
  for (const Curve& curve : shape.contours) {
    const Curve placed = transform(curve, place);
    paths.push_back(to_cubic_path(placed, 1e-3 * placed.extent()));
  }
  return format_path_data(paths, {}, 1);
}

}  // namespace

void Sheet::add_row(const std::string& label, const std::vector<Shape>& shapes) {
  Box box;
  for (const Shape& shape : shapes) box.include(bounding_box(shape));
  const double scale = std::min((cell_width_ - kMargin) / std::max(box.hi[0] - box.lo[0], 1e-9),
                                (cell_height_ - kMargin) / std::max(box.hi[1] - box.lo[1], 1e-9));
  std::string row;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const Point center = box.center();
    const double x = (static_cast<double>(k) + 0.5) * cell_width_;
    const Transform place = Transform::translate(x, 0.5 * cell_height_) * Transform::scale(scale, scale) *
                            Transform::translate(-center[0], -center[1]);
    const bool filled = shapes[k].contours.front().is_closed();
    row +=
        fmt::format("<path class=\"{}\" d=\"{}\"/>\n", filled ? "fill" : "line", path_of(shapes[k], place));
  }
  add_svg(label, row, cell_width_ * static_cast<double>(shapes.size()), cell_height_);
}

void Sheet::add_svg(const std::string& label, const std::string& svg, double width, double height) {
  body_ += fmt::format(
      "<text x=\"{0:.0f}\" y=\"{1:.0f}\">{2}</text>\n<g transform=\"translate({0:.0f} {3:.0f})\">\n{4}</g>\n",
      kMargin, kMargin + height_ + 14.0, label, kMargin + height_ + kLabelHeight, svg);
  width_ = std::max(width_, width);
  height_ += kLabelHeight + height;
}

std::string Sheet::svg() const {
  const double width = width_ + 2.0 * kMargin;
  const double height = height_ + 2.0 * kMargin;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\">\n"
      "<style>text{{font:13px sans-serif;fill:#333}}.small{{font-size:11px}}.middle{{text-anchor:middle}}"
      ".fill{{fill:#3b6b8f}}.line{{fill:none;stroke:#3b6b8f;stroke-width:2}}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{2}</svg>\n",
      width, height, body_);
}

std::vector<Shape> naive_in_betweens(const Curve& a, const Curve& b, const std::vector<double>& times) {
  const std::array<Curve, 2> pair = {clamp(a), with_domain(clamp(b), a.domain())};
  const std::vector<Curve> keys = with_common_denominator(pair);
  std::vector<Shape> shapes;
  for (double s : times) {
    Points points = keys[0].control_points();
    for (std::size_t k = 0; k < points.data().size(); ++k) {
      points.data()[k] =
          (1.0 - s) * keys[0].control_points().data()[k] + s * keys[1].control_points().data()[k];
    }
    shapes.push_back({{Curve(keys[0].degree(), keys[0].knots(), std::move(points), keys[0].weights())}});
  }
  return shapes;
}

}  // namespace tandem::figures
