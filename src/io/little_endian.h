#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
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
