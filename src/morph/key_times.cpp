#include "tandem/morph/key_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "morph/chosen_times.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

void check_finite(double s) {
  if (!std::isfinite(s)) throw InvalidArgument(fmt::format("morph: s is {}, expected a finite number", s));
}

}  // namespace

KeyPosition locate_key(double s, std::size_t key_count) {
  if (key_count < 2) {
    throw InvalidArgument(fmt::format("morph: {} keys, expected at least 2", key_count));
  }
  check_finite(s);
  const double last = static_cast<double>(key_count - 1);
  double x = s * last;
  // i / last * last may miss i by a rounding; a key's own s must give the key.
  const double nearest = std::round(x);
  if (nearest / last == s) x = nearest;
  const double key = std::clamp(std::floor(x), 0.0, last - 1.0);
  return {static_cast<std::size_t>(key), x - key};
}

KeyPosition locate_key(double s, std::span<const double> times) {
  check_key_times(times);
  check_finite(s);
  const auto above = std::upper_bound(times.begin() + 1, times.end() - 1, s);
  const auto key = static_cast<std::size_t>(above - times.begin()) - 1;
  return {key, (s - times[key]) / (times[key + 1] - times[key])};
}

std::vector<double> even_times(std::size_t key_count) {
  std::vector<double> times;
  for (std::size_t key = 0; key < key_count; ++key) {
    times.push_back(static_cast<double>(key) / static_cast<double>(key_count - 1));
  }
  return times;
}

void check_key_times(std::span<const double> times) {
  const bool rising = times.size() >= 2 && times.front() == 0.0 && times.back() == 1.0 &&
                      std::adjacent_find(times.begin(), times.end(),
                                         [](double a, double b) { return !(a < b); }) == times.end();
  if (rising) return;
  throw InvalidArgument(
      fmt::format("the times of the keys are {}, expected to rise from 0 to 1", fmt::join(times, ", ")));
}

namespace detail {

std::vector<double> chosen_times(std::span<const double> times, std::size_t key_count) {
  if (times.empty()) return even_times(key_count);
  if (times.size() != key_count) {
    throw InvalidArgument(
        fmt::format("morph: {} times, expected one for each of the {} keys", times.size(), key_count));
  }
  check_key_times(times);
  return {times.begin(), times.end()};
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
