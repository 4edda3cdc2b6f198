#include "key_times.h"

#include <fmt/format.h>

#include <string_view>

#include "values.h"

namespace cli {
namespace {

constexpr double kLongestDuration = 86'400.0;  // a day, in seconds, as of --duration

/// The unit that all parts end with, taken off them: "", "%" or "s".
std::string take_unit(std::vector<std::string>& parts, const std::string& text) {
  const char last = parts.front().back();
  const std::string unit = last == '%' || last == 's' ? std::string(1, last) : "";
  for (std::string& part : parts) {
    const bool has_unit = part.back() == '%' || part.back() == 's';
    if (has_unit == unit.empty() || (has_unit && part.back() != unit.front())) {
      throw UsageError(
          fmt::format("--times takes times of one kind, as in 0,0.4,1 or 0%,40%,100% or "
                      "0s,0.8s,2s, not '{}'",
                      text));
    }
    if (has_unit) part.pop_back();
  }
  return unit;
}

}  // namespace

KeyTimes parse_key_times(const std::string& text, std::size_t count) {
  KeyTimes times;
  if (text.empty()) return times;
  std::vector<std::string> parts = split_list("--times", text);
  if (parts.size() != count) {
    throw UsageError(
        fmt::format("--times takes a time for each of the {} shapes, not {}", count, parts.size()));
  }
  const std::string unit = take_unit(parts, text);
  for (const std::string& part : parts) times.shares.push_back(parse_number("--times", part));
  const double whole = unit == "s" ? times.shares.back() : unit == "%" ? 100.0 : 1.0;
  bool rising = times.shares.front() == 0.0 && times.shares.back() == whole;
  for (std::size_t i = 1; i < count; ++i) rising = rising && times.shares[i] > times.shares[i - 1];
  if (!rising || (unit == "s" && !(whole >= 1e-3 && whole <= kLongestDuration))) {
    throw UsageError(fmt::format("--times takes times that rise from 0 to {}, not '{}'",
                                 unit == "s"   ? "the duration"
                                 : unit == "%" ? "100%"
                                               : "1",
                                 text));
  }
  for (double& share : times.shares) share /= whole;
  if (unit == "s") times.duration = whole;
  return times;
}

}  // namespace cli
