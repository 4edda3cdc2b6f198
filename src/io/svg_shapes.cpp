#include "io/svg_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "io/path_data_reader.h"
#include "io/svg_values.h"
#include "tandem/error.h"
#include "tandem/shape/path_builder.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr std::array<std::string_view, 7> kShapes = {"path",     "rect",    "circle", "ellipse",
                                                     "polyline", "polygon", "line"};

std::optional<double> reference_length(SvgAxis axis, const SvgViewport& viewport) {
  if (axis == SvgAxis::x) return viewport.width;
  if (axis == SvgAxis::y) return viewport.height;
  if (!viewport.width || !viewport.height) return std::nullopt;
  const double w = *viewport.width;
  const double h = *viewport.height;
  const double larger = std::max(w, h);
  if (larger == 0.0) return 0.0;
  return larger * std::sqrt(((w / larger) * (w / larger) + (h / larger) * (h / larger)) / 2.0);
}

/// The attributes of one element and the pen that draws it.
class ShapeReader {
 public:
  ShapeReader(const SvgDocument& document, const pugi::xml_node& node, const Transform& transform,
              const SvgViewport& viewport)
      : document_(document), node_(node), viewport_(viewport) {
    pen_.set_transform(transform);
  }

  std::vector<CubicPath> read(std::string_view name) {
    if (name == "rect") rect();
    if (name == "circle") circle();
    if (name == "ellipse") ellipse();
    if (name == "line") line();
    if (name == "polyline" || name == "polygon") polyline(name == "polygon");
    return pen_.take();
  }

 private:
  double length(const char* attribute, SvgAxis axis) const {
    return read_length(document_, node_, attribute, axis, viewport_).value_or(0.0);
  }

  std::optional<double> size(const char* attribute, SvgAxis axis) const {
    const std::optional<double> size = read_length(document_, node_, attribute, axis, viewport_);
    if (size && *size < 0.0)
      document_.fail(node_, attribute, {0, fmt::format("a size of {} is negative", *size)});
    return size;
  }

  void rect() {
    const double x = length("x", SvgAxis::x);
    const double y = length("y", SvgAxis::y);
    const double w = size("width", SvgAxis::x).value_or(0.0);
    const double h = size("height", SvgAxis::y).value_or(0.0);
    if (w == 0.0 || h == 0.0) return;
    std::optional<double> rx = size("rx", SvgAxis::x);
    std::optional<double> ry = size("ry", SvgAxis::y);
    if (!rx) rx = ry;
    if (!ry) ry = rx;
    const Vec2 r = {std::min(rx.value_or(0.0), w / 2.0), std::min(ry.value_or(0.0), h / 2.0)};
    if (r.x == 0.0 || r.y == 0.0) {
      pen_.move_to({x, y});
      pen_.line_to({x + w, y});
      pen_.line_to({x + w, y + h});
      pen_.line_to({x, y + h});
      pen_.close();
      return;
    }
    pen_.move_to({x + r.x, y});
    pen_.line_to({x + w - r.x, y});
    corner(r, {x + w, y + r.y});
    pen_.line_to({x + w, y + h - r.y});
    corner(r, {x + w - r.x, y + h});
    pen_.line_to({x + r.x, y + h});
    corner(r, {x, y + h - r.y});
    pen_.line_to({x, y + r.y});
    corner(r, {x + r.x, y});
    pen_.close();
  }

  void corner(Vec2 radii, Vec2 to) { pen_.arc_to(radii, 0.0, false, true, to); }

  void circle() {
    const double r = size("r", SvgAxis::diagonal).value_or(0.0);
    round({length("cx", SvgAxis::x), length("cy", SvgAxis::y)}, {r, r});
  }

  void ellipse() {
    std::optional<double> rx = size("rx", SvgAxis::x);
    std::optional<double> ry = size("ry", SvgAxis::y);
    if (!rx) rx = ry;
    if (!ry) ry = rx;
    round({length("cx", SvgAxis::x), length("cy", SvgAxis::y)}, {rx.value_or(0.0), ry.value_or(0.0)});
  }

  /// Four quarters from the right end on, as SVG 2 has it.
  void round(Vec2 center, Vec2 r) {
    if (r.x == 0.0 || r.y == 0.0) return;
    pen_.move_to({center.x + r.x, center.y});
    corner(r, {center.x, center.y + r.y});
    corner(r, {center.x - r.x, center.y});
    corner(r, {center.x, center.y - r.y});
    corner(r, {center.x + r.x, center.y});
    pen_.close();
  }

  void line() {
    pen_.move_to({length("x1", SvgAxis::x), length("y1", SvgAxis::y)});
    pen_.line_to({length("x2", SvgAxis::x), length("y2", SvgAxis::y)});
  }

  void polyline(bool close) {
    std::vector<Vec2> points;
    try {
      points = parse_point_list(node_.attribute("points").value());
    } catch (const SyntaxError& error) {
      document_.fail(node_, "points", error);
    }
    if (points.empty()) return;
    pen_.move_to(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) pen_.line_to(points[i]);
    if (close) pen_.close();
  }

  const SvgDocument& document_;
  const pugi::xml_node& node_;
  const SvgViewport& viewport_;
  PathBuilder pen_;
};

std::vector<CubicPath> read_path(const SvgDocument& document, const pugi::xml_node& node, bool fill,
                                 const Transform& transform) {
  try {
    std::vector<CubicPath> paths = read_path_data(node.attribute("d").value(), fill, transform);
    return fill ? paths : close_meeting_outlines(std::move(paths));
  } catch (const SyntaxError& error) {
    document.fail(node, "d", error);
  }
}

}  // namespace

std::optional<double> length_in(const SvgLength& length, SvgAxis axis, const SvgViewport& viewport) {
  if (length.kind == SvgLength::Kind::user) return length.value;
  const std::optional<double> whole = reference_length(axis, viewport);
  if (!whole) return std::nullopt;
  return length.value / 100.0 * *whole;
}

std::optional<double> read_length(const SvgDocument& document, const pugi::xml_node& node,
                                  const char* attribute, SvgAxis axis, const SvgViewport& viewport) {
  const pugi::xml_attribute value = node.attribute(attribute);
  if (!value) return std::nullopt;
  SvgLength length;
  try {
    length = parse_length(value.value());
  } catch (const SyntaxError& error) {
    document.fail(node, attribute, error);
  }
  if (length.kind == SvgLength::Kind::automatic) return std::nullopt;
  const std::optional<double> found = length_in(length, axis, viewport);
  if (!found) {
    document.fail(node, attribute, {0, "a percentage needs a viewBox, or a width and height, of the <svg>"});
  }
  return found;
}

bool is_svg_shape(std::string_view name) {
  return std::find(kShapes.begin(), kShapes.end(), name) != kShapes.end();
}

std::vector<CubicPath> read_svg_shape(const SvgDocument& document, const pugi::xml_node& node,
                                      std::string_view name, bool fill, const Transform& transform,
                                      const SvgViewport& viewport) {
  if (name == "path") return read_path(document, node, fill, transform);
  constexpr const char* kTooLarge = "the shape reaches beyond the largest coordinate, 1e300";
  try {
    std::vector<CubicPath> paths = ShapeReader(document, node, transform, viewport).read(name);
    if (!std::all_of(paths.begin(), paths.end(), is_in_range)) document.fail(node, kTooLarge);
    return fill ? close_meeting_ends(std::move(paths)) : close_meeting_outlines(std::move(paths));
  } catch (const InvalidArgument&) {
    document.fail(node, kTooLarge);
  }
}

}  // namespace v0
}  // namespace tandem
