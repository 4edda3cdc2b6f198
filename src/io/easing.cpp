#include "io/easing.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <array>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == ',';
}

}  // namespace

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

}  // namespace v0
}  // namespace tandem
