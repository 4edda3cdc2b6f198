#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/json_curves.h"
#include "io/json_fields.h"
#include "io/json_value.h"
#include "io/text_position.h"
#include "tandem/error.h"
#include "tandem/io/json.h"
#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {
namespace {

/// Ends of a closed bezier_path that differ by no more than this share of its size are taken for one point;
/// it is the tolerance by which a Curve calls itself closed.
constexpr double kMeetingEnds = 1e-9;

class CurveReader : private JsonFields {
 public:
  CurveReader(std::string_view text, const std::string& source, std::size_t index)
      : JsonFields(text, source, fmt::format("curve {}", index)) {}

  [[nodiscard]] Curve read(const JsonValue& value) const {
    if (value.object() == nullptr) fail(value, fmt::format("expected an object, found {}", value.kind()));
    const std::string type = read_type(value);
    if (type == "bspline_surface")
      fail(value, "is a surface; expected a curve (\"bspline\" or \"bezier_path\")");
    if (type != "bspline" && type != "bezier_path") {
      fail(value, fmt::format("unknown type \"{}\"; expected \"bspline\" or \"bezier_path\"", type));
    }
    try {
      return type == "bspline" ? read_bspline(value) : read_bezier_path(value);
    } catch (const InvalidArgument& error) {
      fail(value, error.what());
    }
  }

 private:
  /// Curves of other programs name no type, but a degree.
  [[nodiscard]] std::string read_type(const JsonValue& value) const {
    const JsonValue* type = value.member("type");
    if (type == nullptr) {
      if (value.member("degree") != nullptr) return "bspline";
      fail(value, "has neither \"type\" nor \"degree\"");
    }
    if (type->text() == nullptr)
      fail(*type, fmt::format("\"type\": expected a string, found {}", type->kind()));
    return *type->text();
  }

  [[nodiscard]] bool flag(const JsonValue& value, std::string_view key) const {
    const JsonValue* member = value.member(key);
    if (member == nullptr) return false;
    if (member->boolean() == nullptr) {
      fail(*member, fmt::format("\"{}\": expected true or false, found {}", key, member->kind()));
    }
    return *member->boolean();
  }

  /// Rows of one length; a bare number is a point of the line.
  [[nodiscard]] Points points(const JsonValue& value) const {
    const JsonValue& member = required(value, "points");
    const JsonValue::Array& rows = array(member, "\"points\"");
    if (rows.empty()) fail(member, "\"points\" is empty");
    const std::size_t dim = rows[0].array() == nullptr ? 1 : rows[0].array()->size();
    if (dim == 0) fail(rows[0], "point 0 has no coordinates");
    std::vector<double> coordinates;
    coordinates.reserve(rows.size() * dim);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const JsonValue::Array* row = rows[i].array();
      const std::size_t size = row == nullptr ? 1 : row->size();
      if (size != dim) {
        fail(rows[i], fmt::format("point {} has {} coordinates, point 0 has {}", i, size, dim));
      }
      for (std::size_t k = 0; k < dim; ++k) {
        coordinates.push_back(number(row == nullptr ? rows[i] : (*row)[k], "a coordinate of point", i));
      }
    }
    return Points(static_cast<int>(dim), std::move(coordinates));
  }

  [[nodiscard]] Curve read_bspline(const JsonValue& value) const {
    const int degree = this->degree(required(value, "degree"), "\"degree\"");
    Points points = this->points(value);
    const bool periodic = flag(value, "periodic");
    std::vector<double> weights;
    if (const JsonValue* member = value.member("weights")) {
      weights = numbers(*member, "\"weights\"", "weight");
      if (weights.empty()) fail(*member, "\"weights\" is empty; leave it out for a polynomial curve");
    }
    std::optional<std::vector<double>> knots;
    if (const JsonValue* member = value.member("knots")) knots = numbers(*member, "\"knots\"", "knot");
    if (!knots && !periodic) return Curve::clamped_uniform(degree, std::move(points), std::move(weights));
    if (!knots) knots = uniform_knots(value, degree, points.size());
    Curve curve(degree, std::move(*knots), std::move(points), std::move(weights));
    if (periodic && !curve.is_periodic()) {
      fail(value,
           fmt::format("is not periodic: its last {} points (weights, knot spans) must repeat the first",
                       degree));
    }
    return curve;
  }

  /// Unclamped, with the domain [0,1].
  [[nodiscard]] std::vector<double> uniform_knots(const JsonValue& value, int degree, std::size_t n) const {
    const auto p = static_cast<std::size_t>(degree);
    if (n <= p) fail(value, fmt::format("has {} points, degree {} needs at least {}", n, degree, p + 1));
    std::vector<double> knots;
    knots.reserve(n + p + 1);
    for (std::size_t i = 0; i < n + p + 1; ++i) {
      knots.push_back((static_cast<double>(i) - static_cast<double>(p)) / static_cast<double>(n - p));
    }
    return knots;
  }

  [[nodiscard]] Curve read_bezier_path(const JsonValue& value) const {
    Points points = this->points(value);
    if (points.size() < 4 || points.size() % 3 != 1) {
      fail(value,
           fmt::format("has {} points, a path of k cubics needs 3 k + 1 (4, 7, 10, ...)", points.size()));
    }
    const bool closed = flag(value, "closed");
    if (closed) close(value, points);
    return to_curve(CubicPath(std::move(points), closed));
  }

  void close(const JsonValue& value, Points& points) const {
    double size = 0.0;
    double gap = 0.0;
    for (int k = 0; k < points.dim(); ++k) {
      const auto coordinate = static_cast<std::size_t>(k);
      const double first = points[0][coordinate];
      for (std::size_t i = 0; i < points.size(); ++i) {
        size = std::max(size, std::fabs(points[i][coordinate] / 2.0 - first / 2.0));
      }
      gap = std::max(gap, std::fabs(points.back()[coordinate] / 2.0 - first / 2.0));
    }
    if (gap > kMeetingEnds * size) fail(value, "is closed, but its last point is not its first");
    const std::size_t last = points.size() - 1;
    for (std::size_t k = 0; k < static_cast<std::size_t>(points.dim()); ++k) points[last][k] = points[0][k];
  }
};

}  // namespace

std::vector<Curve> parse_json_curves(std::string_view text, const std::string& source) {
  text = without_bom(text);
  return read_json_curves(parse_json(text, source), text, source);
}

std::vector<Curve> read_json_curves(const JsonValue& root, std::string_view text, const std::string& source) {
  const JsonValue* list = root.array() != nullptr ? &root : root.member("curves");
  std::vector<Curve> curves;
  if (list == nullptr) {
    const bool curve = root.member("type") != nullptr || root.member("degree") != nullptr;
    if (!curve) {
      fail_at(source, text, root.offset,
              fmt::format("expected a curve, an array of curves, or an object with \"curves\", found {}{}",
                          root.kind(), root.object() != nullptr ? " without any of these" : ""));
    }
    curves.push_back(CurveReader(text, source, 0).read(root));
    return curves;
  }
  if (list->array() == nullptr) {
    fail_at(source, text, list->offset, fmt::format("\"curves\": expected an array, found {}", list->kind()));
  }
  if (list->array()->empty()) fail_at(source, text, list->offset, "there is no curve in the list");
  curves.reserve(list->array()->size());
  for (const JsonValue& item : *list->array()) {
    curves.push_back(CurveReader(text, source, curves.size()).read(item));
  }
  return curves;
}

}  // namespace v0
}  // namespace tandem
