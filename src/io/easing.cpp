#include "io/easing.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == ',';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

// The blossom of the Bezier curve with the coordinates 0, p, q, 1.
double blossom(double p, double q, double a, double b, double c) {
  const double first = (1.0 - b) * ((1.0 - a) * 0.0 + a * p) + b * ((1.0 - a) * p + a * q);
  const double second = (1.0 - b) * ((1.0 - a) * p + a * q) + b * ((1.0 - a) * q + a * 1.0);
  return (1.0 - c) * first + c * second;
}

// The parameter at which a rising coordinate takes a value.
double solve(double p, double q, double value) {
  if (value <= 0.0) return 0.0;
  if (value >= 1.0) return 1.0;
  constexpr int kHalvings = 60;  // to the last bits
  double lo = 0.0;
  double hi = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (lo + hi);
    (blossom(p, q, middle, middle, middle) < value ? lo : hi) = middle;
  }
  return 0.5 * (lo + hi);
}

}  // namespace

double ease(const Easing& easing, double x) {
  if (easing.linear()) return x;
  const double t = solve(easing.x1, easing.x2, x);
  return blossom(easing.y1, easing.y2, t, t, t);
}

EasingPart part_of(const Easing& easing, double from, double to) {
  if (easing.linear()) return {from, {}};
  const double t0 = solve(easing.y1, easing.y2, from);
  const double t1 = solve(easing.y1, easing.y2, to);
  const auto controls = [&](double p, double q) {
    const double start = blossom(p, q, t0, t0, t0);
    const double end = blossom(p, q, t1, t1, t1);
    const auto share = [&](double x) { return std::clamp((x - start) / (end - start), 0.0, 1.0); };
    return std::array<double, 2>{share(blossom(p, q, t0, t0, t1)), share(blossom(p, q, t0, t1, t1))};
  };
  const auto [x1, x2] = controls(easing.x1, easing.x2);
  const auto [y1, y2] = controls(easing.y1, easing.y2);
  return {blossom(easing.x1, easing.x2, t0, t0, t0), {x1, y1, x2, y2}};
}

Easing reversed(const Easing& easing) {
  return {1.0 - easing.x2, 1.0 - easing.y2, 1.0 - easing.x1, 1.0 - easing.y1};
}

Easing parse_easing(std::string_view text) {
  if (text == "linear") return {};
  if (text == "ease") return {0.25, 0.1, 0.25, 1.0};
  if (text == "ease-in") return {0.42, 0.0, 1.0, 1.0};
  if (text == "ease-out") return {0.0, 0.0, 0.58, 1.0};
  if (text == "ease-in-out") return {0.42, 0.0, 0.58, 1.0};

  std::array<double, 4> numbers{};
  std::size_t count = 0;
  const char* at = text.data();
  const char* const end = at + text.size();
  bool good = true;
  while (good) {
    while (at != end && is_separator(*at)) ++at;
    if (at == end) break;
    double x = 0.0;
    const auto parsed = fast_float::from_chars(at, end, x);
    // SMIL allows no overshoot: all four in [0,1]. Two numbers need something between them.
    good = parsed.ec == std::errc() && count < 4 && x >= 0.0 && x <= 1.0 &&
           (parsed.ptr == end || is_separator(*parsed.ptr));
    if (good) numbers[count++] = x;
    at = parsed.ptr;
  }
  if (!good || count != 4) {
    throw InvalidArgument(
        fmt::format("easing is '{}', expected linear, ease, ease-in, ease-out, ease-in-out, or four "
                    "numbers in [0,1] as in '0.4 0 0.6 1'",
                    text));
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::vector<Easing> parse_easings(std::string_view text, std::size_t steps) {
  std::vector<Easing> easings;
  for (;;) {
    const std::size_t end = text.find(';');
    easings.push_back(parse_easing(trimmed(text.substr(0, end))));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  if (easings.size() == 1 || easings.size() == steps) return easings;
  throw InvalidArgument(fmt::format(
      "{} easings, expected one, or one for each of the {} steps from key to key", easings.size(), steps));
}

}  // namespace v0
}  // namespace tandem
