#include "pins.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "tandem/curve/nearest_point.h"
#include "tandem/error.h"
#include "values.h"

namespace cli {
namespace {

using tandem::NearestPoint;
using tandem::ParameterPair;
using tandem::Point;

Point parse_point(const std::string& text, const std::string& pin) {
  const std::vector<std::string> parts = split_list("--pin", text);
  if (parts.size() != 2) throw UsageError("--pin takes x1,y1=x2,y2, not '" + pin + "'");
  return {parse_number("--pin", parts[0]), parse_number("--pin", parts[1])};
}

/// The points of x1,y1=x2,y2.
std::pair<Point, Point> parse_pin(const std::string& pin) {
  const std::size_t equals = pin.find('=');
  if (equals == std::string::npos || pin.find('=', equals + 1) != std::string::npos) {
    throw UsageError("--pin takes x1,y1=x2,y2, not '" + pin + "'");
  }
  return {parse_point(pin.substr(0, equals), pin), parse_point(pin.substr(equals + 1), pin)};
}

ParameterPair parse_time_pin(const std::string& pin) {
  const std::size_t equals = pin.find('=');
  if (equals == std::string::npos || pin.find('=', equals + 1) != std::string::npos) {
    throw UsageError("--pin takes t1=t2 for motions, not '" + pin + "'");
  }
  return {parse_number("--pin", pin.substr(0, equals)), parse_number("--pin", pin.substr(equals + 1))};
}

}  // namespace

bool are_time_pins(const std::vector<std::string>& pins) {
  return !pins.empty() && std::all_of(pins.begin(), pins.end(), [](const std::string& pin) {
    return pin.find(',') == std::string::npos;
  });
}

std::vector<ParameterPair> parse_time_pins(const std::vector<std::string>& pins) {
  std::vector<ParameterPair> parsed;
  for (const std::string& pin : pins) parsed.push_back(parse_time_pin(pin));
  return parsed;
}

std::vector<std::vector<ParameterPair>> locate_pins(const std::vector<std::string>& pins,
                                                    const tandem::Shape& a, const tandem::Shape& b) {
  const std::size_t count = std::min(a.contours.size(), b.contours.size());
  std::vector<std::vector<ParameterPair>> located(count);
  if (are_time_pins(pins) && count > 0) {
    located.front() = parse_time_pins(pins);
    return located;
  }
  for (const std::string& pin : pins) {
    const auto [on_a, on_b] = parse_pin(pin);
    if (count == 0) throw tandem::InvalidArgument("--pin " + pin + ": there are no contours to pin");
    double least = std::numeric_limits<double>::infinity();
    std::size_t pair = 0;
    ParameterPair nearest;
    for (std::size_t i = 0; i < count; ++i) {
      const NearestPoint u = tandem::nearest_point(a.contours[i], on_a);
      const NearestPoint v = tandem::nearest_point(b.contours[i], on_b);
      if (i > 0 && !(u.distance + v.distance < least)) continue;
      least = u.distance + v.distance;
      pair = i;
      nearest = {u.parameter, v.parameter};
    }
    located[pair].push_back(nearest);
  }
  return located;
}

std::vector<tandem::MorphPin> parse_pins(const std::vector<std::string>& pins) {
  std::vector<tandem::MorphPin> parsed;
  for (const std::string& pin : pins) {
    const auto [a, b] = parse_pin(pin);
    parsed.push_back({{a[0], a[1]}, {b[0], b[1]}});
  }
  return parsed;
}

}  // namespace cli
