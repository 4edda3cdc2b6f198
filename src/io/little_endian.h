#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Appends the lowest byte first, on every machine.
inline void put_word(std::string& bytes, std::uint64_t word) {
  for (int k = 0; k < 8; ++k, word >>= 8U) bytes += static_cast<char>(word & 0xFFU);
}

inline void put_half_word(std::string& bytes, std::uint32_t word) {
  for (int k = 0; k < 4; ++k, word >>= 8U) bytes += static_cast<char>(word & 0xFFU);
}

/// As a float of 32 bits. @throws InvalidArgument there is none as large
inline void put_float(std::string& bytes, double number) {
  if (!(std::fabs(number) <= std::numeric_limits<float>::max())) {
    throw InvalidArgument(
        fmt::format("{} does not fit a number of 32 bits, which this format has; scale the input", number));
  }
  const auto rounded = static_cast<float>(number);
  std::uint32_t word = 0;
  std::memcpy(&word, &rounded, sizeof word);
  put_half_word(bytes, word);
}

/// Whether floats of 32 bits tell points of this cloud apart, as far as a picture of it needs that.
/// @throws InvalidArgument they do not: it lies too far from the origin for its size
inline void check_floats(std::span<const double> numbers, std::size_t dim) {
  double size = 0.0;
  double most = 0.0;
  for (std::size_t c = 0; c < dim; ++c) {
    double lo = std::numeric_limits<double>::infinity();
    double hi = -lo;
    for (std::size_t k = c; k < numbers.size(); k += dim) {
      lo = std::min(lo, numbers[k]);
      hi = std::max(hi, numbers[k]);
    }
    if (!(lo <= hi)) return;
    size = std::max(size, hi - lo);
    most = std::max({most, std::fabs(lo), std::fabs(hi)});
  }
  constexpr double kSteps = 1000.0;  // across the whole
  if (size >= kSteps * most * std::numeric_limits<float>::epsilon()) return;
  throw InvalidArgument(
      fmt::format("numbers of 32 bits, which this format has, do not tell points of something of size {:.3g} "
                  "apart at coordinates of {:.3g}; move it to the origin, or write .ply, .obj or .json",
                  size, most));
}

inline void put_number(std::string& bytes, double number) {
  std::uint64_t word = 0;
  std::memcpy(&word, &number, sizeof word);
  put_word(bytes, word);
}

/// The eight bytes from `at`, which must be there.
[[nodiscard]] inline std::uint64_t get_word(std::string_view bytes, std::size_t at) {
  std::uint64_t word = 0;
  for (std::size_t k = 8; k-- > 0;) word = word << 8U | static_cast<unsigned char>(bytes[at + k]);
  return word;
}

[[nodiscard]] inline double get_number(std::string_view bytes, std::size_t at) {
  const std::uint64_t word = get_word(bytes, at);
  double number = 0.0;
  std::memcpy(&number, &word, sizeof number);
  return number;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
