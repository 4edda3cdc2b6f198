#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

#include "commands.h"
#include "output.h"
#include "report.h"
#include "tandem/curve/arc_length.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/version.h"

namespace cli {
namespace {

using tandem::Along;
using tandem::Box;
using tandem::Curve;
using tandem::Shape;
using tandem::Surface;

constexpr double kLengthAccuracy = 1e-9;  // relative; more digits than are printed for people

bool is_bezier(const Curve& curve) {
  const auto degree = static_cast<std::size_t>(curve.degree());
  return curve.size() == degree + 1 && curve.knots().front() == curve.knots()[degree] &&
         curve.knots().back() == curve.knots()[curve.size()];
}

std::string_view kind(const Curve& curve) {
  return is_bezier(curve) ? "bezier" : "bspline";
}

std::string_view fill_rule(const Shape& shape) {
  return shape.fill_rule == tandem::FillRule::evenodd ? "evenodd" : "nonzero";
}

std::string json_point(const tandem::Point& point) {
  std::string text = "[";
  for (const double x : point) text += (text.size() == 1 ? "" : ", ") + json_number(x);
  return text + "]";
}

std::string json_box(const Box& box) {
  return fmt::format(R"({{"lo": {}, "hi": {}}})", json_point(box.lo), json_point(box.hi));
}

std::string format_json(const std::string& name, const Shape& shape) {
  double length = 0.0;
  std::string contours;
  for (const Curve& curve : shape.contours) {
    const double part = tandem::arc_length(curve, kLengthAccuracy);
    length += part;
    contours += fmt::format(
        R"({}{{"kind": "{}", "degree": {}, "dimension": {}, "control_points": {}, "domain": [{}, {}], "closed": {}, )"
        R"("periodic": {}, "rational": {}, "length": {}, "box": {}}})",
        contours.empty() ? "" : ",\n  ", kind(curve), curve.degree(), curve.dim(), curve.size(),
        json_number(curve.domain().lo), json_number(curve.domain().hi), curve.is_closed(),
        curve.is_periodic(), curve.is_rational(), json_number(part), json_box(tandem::bounding_box(curve)));
  }
  return fmt::format(
      R"({{"tandem": {}, "name": {}, "dimension": {}, "fill_rule": "{}", "length": {}, "box": {}, "contours": [)"
      "\n  {}]}}\n",
      json_string(tandem::version()), json_string(name), shape.dim(), fill_rule(shape), json_number(length),
      json_box(tandem::bounding_box(shape)), contours);
}

std::string yes_no(bool value) {
  return value ? "yes" : "no";
}

std::string text_point(const tandem::Point& point) {
  std::string text;
  for (const double x : point) text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", x);
  return "(" + text + ")";
}

std::string format_text(const std::string& name, const Shape& shape) {
  double length = 0.0;
  std::string rows;
  for (std::size_t i = 0; i < shape.contours.size(); ++i) {
    const Curve& curve = shape.contours[i];
    const double part = tandem::arc_length(curve, kLengthAccuracy);
    length += part;
    rows += fmt::format(
        "{:>4}  {:<7}  {:>6}  {:>6}  {:<14}  {:<6}  {:<8}  {:<8}  {:.6g}\n", i, kind(curve), curve.degree(),
        curve.size(), fmt::format("[{:.6g}, {:.6g}]", curve.domain().lo, curve.domain().hi),
        yes_no(curve.is_closed()), yes_no(curve.is_periodic()), yes_no(curve.is_rational()), part);
  }
  const Box box = tandem::bounding_box(shape);
  return fmt::format(
      "{}\n{} contour{}, dimension {}, fill rule {}, box {} to {}, length {:.6g}\n"
      "{:>4}  {:<7}  {:>6}  {:>6}  {:<14}  {:<6}  {:<8}  {:<8}  {}\n{}",
      name, shape.contours.size(), shape.contours.size() == 1 ? "" : "s", shape.dim(), fill_rule(shape),
      text_point(box.lo), text_point(box.hi), length, "#", "kind", "degree", "points", "domain", "closed",
      "periodic", "rational", "length", rows);
}

/// Of the control points, which hold the surface.
Box hull_box(const Surface& surface) {
  const tandem::Points& points = surface.control_points();
  Box box{{points[0].begin(), points[0].end()}, {points[0].begin(), points[0].end()}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < box.lo.size(); ++k) {
      box.lo[k] = std::min(box.lo[k], points[i][k]);
      box.hi[k] = std::max(box.hi[k], points[i][k]);
    }
  }
  return box;
}

std::string format_json(const std::string& name, const Surface& surface) {
  const auto both = [&](auto value) { return fmt::format("[{}, {}]", value(Along::u), value(Along::v)); };
  const auto domain = [&](Along along) {
    const tandem::Interval d = surface.domain(along);
    return fmt::format("[{}, {}]", json_number(d.lo), json_number(d.hi));
  };
  return fmt::format(
      R"({{"tandem": {}, "name": {}, "kind": "surface", "degree": {}, "dimension": {}, "control_points": {}, )"
      R"("domain": {}, "closed": {}, "rational": {}, "box": {}}})"
      "\n",
      json_string(tandem::version()), json_string(name), both([&](Along a) { return surface.degree(a); }),
      surface.dim(), both([&](Along a) { return surface.size(a); }), both(domain),
      both([&](Along a) { return surface.is_closed(a); }), surface.is_rational(),
      json_box(hull_box(surface)));
}

std::string format_text(const std::string& name, const Surface& surface) {
  const Box box = hull_box(surface);
  std::string rows;
  for (const Along along : {Along::u, Along::v}) {
    const tandem::Interval domain = surface.domain(along);
    rows +=
        fmt::format("{:>5}  {:>6}  {:>6}  {:<14}  {}\n", along == Along::u ? "u" : "v", surface.degree(along),
                    surface.size(along), fmt::format("[{:.6g}, {:.6g}]", domain.lo, domain.hi),
                    yes_no(surface.is_closed(along)));
  }
  return fmt::format(
      "{}\nsurface, dimension {}, {}, control points from {} to {}\n{:>5}  {:>6}  {:>6}  {:<14}  {}\n{}",
      name, surface.dim(), surface.is_rational() ? "rational" : "polynomial", text_point(box.lo),
      text_point(box.hi), "along", "degree", "points", "domain", "closed", rows);
}

Status run(const Command& command) {
  const std::variant<Shape, Surface> loaded = load_any_input(command);
  const std::string& name = command.inputs.front();
  const std::string text = std::visit(
      [&](const auto& it) { return command.common.json ? format_json(name, it) : format_text(name, it); },
      loaded);
  write_output("-", text);
  return kDone;
}

void add_flags(Command& command) {
  command.app->add_option("shape", command.inputs, "A file, a part of a file, or path data");
  add_common_flags(*command.app, command.common);
}

}  // namespace

const Subcommand kInfoCommand = {
    "info", "What is in there: kind, degree, dimension, domain, length, contours", add_flags, run};

}  // namespace cli
