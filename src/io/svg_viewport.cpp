#include "io/svg_viewport.h"

#include <fmt/format.h>

#include <string_view>

namespace tandem {
inline namespace v0 {
namespace {

constexpr double kSmallestSize = 1e-300;  // of a view box

/// A percentage of an unknown size is unknown.
std::optional<double> read_size(const SvgDocument& document, const pugi::xml_node& node,
                                const char* attribute, SvgAxis axis, const SvgViewport& outer) {
  const std::string_view text = node.attribute(attribute).value();
  const bool unknown = axis == SvgAxis::x ? !outer.width : !outer.height;
  if (unknown && text.find('%') != std::string_view::npos) return std::nullopt;
  const std::optional<double> size = read_length(document, node, attribute, axis, outer);
  if (size && *size < 0.0) {
    document.fail(node, attribute, {0, fmt::format("a size of {} is negative", *size)});
  }
  return size;
}

std::optional<ViewBox> read_view_box(const SvgDocument& document, const pugi::xml_node& node) {
  const pugi::xml_attribute attribute = node.attribute("viewBox");
  if (!attribute) return std::nullopt;
  try {
    return parse_view_box(attribute.value());
  } catch (const SyntaxError& error) {
    document.fail(node, "viewBox", error);
  }
}

}  // namespace

std::optional<ViewBox> enter_outermost_viewport(const SvgDocument& document, const pugi::xml_node& node,
                                                SvgViewport& viewport) {
  std::optional<ViewBox> shown = read_view_box(document, node);
  viewport = {read_size(document, node, "width", SvgAxis::x, {}),
              read_size(document, node, "height", SvgAxis::y, {})};
  if (shown) {
    viewport = {shown->width, shown->height};
  } else if (viewport.width && viewport.height) {
    shown = ViewBox{0.0, 0.0, *viewport.width, *viewport.height};
  }
  // Below the smallest coordinate that files have, pixels per unit overflow.
  if (shown && (shown->width < kSmallestSize || shown->height < kSmallestSize)) return std::nullopt;
  return shown;
}

bool enter_inner_viewport(const SvgDocument& document, const pugi::xml_node& node, const pugi::xml_node& use,
                          Transform& transform, SvgViewport& viewport) {
  const std::optional<ViewBox> box = read_view_box(document, node);
  const SvgViewport outer = viewport;
  SvgViewport size = {read_size(document, node, "width", SvgAxis::x, outer),
                      read_size(document, node, "height", SvgAxis::y, outer)};
  if (use && use.attribute("width")) size.width = read_size(document, use, "width", SvgAxis::x, outer);
  if (use && use.attribute("height")) size.height = read_size(document, use, "height", SvgAxis::y, outer);
  if (!size.width) size.width = outer.width;
  if (!size.height) size.height = outer.height;
  const double x = read_length(document, node, "x", SvgAxis::x, outer).value_or(0.0);
  const double y = read_length(document, node, "y", SvgAxis::y, outer).value_or(0.0);
  transform = transform * Transform::translate(x, y);
  if (size.width == 0.0 || size.height == 0.0) return false;
  viewport = size;
  if (!box) return true;
  if (box->width == 0.0 || box->height == 0.0) return false;
  viewport = {box->width, box->height};
  if (!size.width || !size.height) return true;  // shown at its own size, for want of another
  try {
    transform = transform *
                fit_view_box(*box, *size.width, *size.height, node.attribute("preserveAspectRatio").value());
  } catch (const SyntaxError& error) {
    document.fail(node, "preserveAspectRatio", error);
  }
  return true;
}

}  // namespace v0
}  // namespace tandem
