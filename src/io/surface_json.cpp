#include "tandem/io/surface_json.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "io/json_fields.h"
#include "io/json_value.h"
#include "io/json_writer.h"
#include "io/text_position.h"
#include "tandem/curve/curve.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr std::string_view kType = "bspline_surface";

bool says_surface(const JsonValue& root) {
  const JsonValue* type = root.member("type");
  return type != nullptr && type->text() != nullptr && *type->text() == kType;
}

class SurfaceReader : private JsonFields {
 public:
  SurfaceReader(std::string_view text, const std::string& source) : JsonFields(text, source, "surface") {}

  [[nodiscard]] Surface read(const JsonValue& root) const {
    if (root.object() == nullptr) fail(root, fmt::format("expected an object, found {}", root.kind()));
    if (!says_surface(root)) fail(root, fmt::format("expected \"type\": \"{}\"", kType));
    try {
      const SurfaceDegree degree = degrees(required(root, "degree"));
      const JsonValue& rows = required(root, "points");
      const std::size_t n = columns(rows);
      Points points = this->points(rows, n);
      SurfaceKnots knots = this->knots(root, degree, {points.size() / n, n});
      return Surface(degree, std::move(knots), std::move(points), weights(root, n));
    } catch (const InvalidArgument& error) {
      fail(root, error.what());
    }
  }

 private:
  [[nodiscard]] const JsonValue::Array& pair(const JsonValue& value, std::string_view name) const {
    const JsonValue::Array& items = array(value, name);
    if (items.size() != 2) fail(value, fmt::format("{} has {} entries, expected 2", name, items.size()));
    return items;
  }

  [[nodiscard]] SurfaceDegree degrees(const JsonValue& value) const {
    const JsonValue::Array& both = pair(value, "\"degree\"");
    return {degree(both[0], "the degree along u"), degree(both[1], "the degree along v")};
  }

  /// Number of points in a row, which all rows share.
  [[nodiscard]] std::size_t columns(const JsonValue& value) const {
    const JsonValue::Array& rows = array(value, "\"points\"");
    if (rows.empty()) fail(value, "\"points\" is empty");
    const std::size_t n = array(rows[0], "row 0 of points").size();
    if (n == 0) fail(rows[0], "row 0 has no points");
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const std::size_t size = array(rows[i], fmt::format("row {} of points", i)).size();
      if (size != n) fail(rows[i], fmt::format("row {} has {} points, row 0 has {}", i, size, n));
    }
    return n;
  }

  [[nodiscard]] Points points(const JsonValue& value, std::size_t n) const {
    const JsonValue::Array& rows = *value.array();
    const std::size_t dim = array((*rows[0].array())[0], "point (0, 0)").size();
    if (dim == 0) fail((*rows[0].array())[0], "point (0, 0) has no coordinates");
    std::vector<double> coordinates;
    coordinates.reserve(rows.size() * n * dim);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        const JsonValue& point = (*rows[i].array())[j];
        const std::string name = fmt::format("point ({}, {})", i, j);
        const JsonValue::Array& numbers = array(point, name);
        if (numbers.size() != dim) {
          fail(point, fmt::format("{} has {} coordinates, point (0, 0) has {}", name, numbers.size(), dim));
        }
        for (std::size_t k = 0; k < dim; ++k) coordinates.push_back(number(numbers[k], name + ", coordinate", k));
      }
    }
    return Points(static_cast<int>(dim), std::move(coordinates));
  }

  [[nodiscard]] SurfaceKnots knots(const JsonValue& root, const SurfaceDegree& degree,
                                   const std::array<std::size_t, 2>& size) const {
    SurfaceKnots result;
    if (const JsonValue* member = root.member("knots")) {
      const JsonValue::Array& both = pair(*member, "\"knots\"");
      result[0] = numbers(both[0], "the knots along u", "knot along u");
      result[1] = numbers(both[1], "the knots along v", "knot along v");
      return result;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      result[k] = Curve::clamped_uniform(degree[k], Points(1, size[k])).knots();
    }
    return result;
  }

  [[nodiscard]] std::vector<double> weights(const JsonValue& root, std::size_t n) const {
    const JsonValue* member = root.member("weights");
    if (member == nullptr) return {};
    const JsonValue::Array& rows = array(*member, "\"weights\"");
    std::vector<double> result;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::vector<double> row = numbers(rows[i], fmt::format("row {} of weights", i), "weight");
      if (row.size() != n) {
        fail(rows[i], fmt::format("row {} has {} weights, expected {}", i, row.size(), n));
      }
      result.insert(result.end(), row.begin(), row.end());
    }
    if (result.empty()) fail(*member, "\"weights\" is empty; leave it out for a polynomial surface");
    return result;
  }
};

}  // namespace

Surface parse_json_surface(std::string_view text, const std::string& source) {
  text = without_bom(text);
  return SurfaceReader(text, source).read(parse_json(text, source));
}

bool is_json_surface(std::string_view text) {
  try {
    return says_surface(parse_json(without_bom(text), "json"));
  } catch (const ParseError&) {
    return false;
  }
}

std::string format_json_surface(const Surface& surface, std::string_view members) {
  const std::size_t m = surface.size(Along::u);
  const std::size_t n = surface.size(Along::v);
  std::string out = fmt::format("{{\"type\": \"{}\", \"degree\": [{}, {}],\n \"knots\": [", kType,
                                surface.degree(Along::u), surface.degree(Along::v));
  append_json_numbers(out, surface.knots(Along::u));
  out += ",\n  ";
  append_json_numbers(out, surface.knots(Along::v));
  out += "],\n \"points\": [";
  for (std::size_t i = 0; i < m; ++i) {
    out += i == 0 ? "[" : ",\n  [";
    for (std::size_t j = 0; j < n; ++j) {
      if (j > 0) out += ", ";
      append_json_numbers(out, surface.control_point(i, j));
    }
    out += ']';
  }
  out += ']';
  for (std::size_t i = 0; surface.is_rational() && i < m; ++i) {
    out += i == 0 ? ",\n \"weights\": [" : ",\n  ";
    append_json_numbers(out, std::span<const double>(surface.weights()).subspan(i * n, n));
    if (i + 1 == m) out += ']';
  }
  if (!members.empty()) out += fmt::format(",\n {}", members);
  return out + "}\n";
}

}  // namespace v0
}  // namespace tandem
