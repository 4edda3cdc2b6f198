#include "io/json_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <iterator>

#include "tandem/error.h"
#include "tandem/io/json.h"

namespace tandem {
inline namespace v0 {

void append_json_number(std::string& out, double value) {
  if (!std::isfinite(value)) throw InvalidArgument(fmt::format("{} cannot be written as JSON", value));
  if (value == 0.0 && std::signbit(value)) {
    out += "-0.0";  // "-0" is an integer to many readers, and loses its sign
  } else {
    fmt::format_to(std::back_inserter(out), "{}", value);
  }
}

void append_json_numbers(std::string& out, std::span<const double> values) {
  out += '[';
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) out += ", ";
    append_json_number(out, values[i]);
  }
  out += ']';
}

void append_json_points(std::string& out, const Points& points) {
  out += '[';
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) out += ", ";
    append_json_numbers(out, points[i]);
  }
  out += ']';
}

void append_json_curve(std::string& out, const Curve& curve) {
  fmt::format_to(std::back_inserter(out), R"({{"type": "bspline", "degree": {}, "knots": )", curve.degree());
  append_json_numbers(out, curve.knots());
  out += R"(, "points": )";
  append_json_points(out, curve.control_points());
  if (curve.is_rational()) {
    out += R"(, "weights": )";
    append_json_numbers(out, curve.weights());
  }
  if (curve.is_periodic()) out += R"(, "periodic": true)";
  out += '}';
}

std::string format_json_curves(std::span<const Curve> curves) {
  std::string out;
  if (curves.size() == 1) {
    append_json_curve(out, curves.front());
    out += '\n';
    return out;
  }
  out += R"({"curves": [)";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    out += i == 0 ? "\n  " : ",\n  ";
    append_json_curve(out, curves[i]);
  }
  out += "\n]}\n";
  return out;
}

}  // namespace v0
}  // namespace tandem
