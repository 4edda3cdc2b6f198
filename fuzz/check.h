#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "tandem/curve/curve.h"

namespace tandem::fuzz {

inline std::string_view text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// What must hold whatever was read: libFuzzer reports the abort with its input.
inline void require(bool holds) {
  if (!holds) std::abort();
}

inline void require_in_range(std::span<const double> coordinates) {
  for (const double x : coordinates) require(std::fabs(x) <= 1e300);
}

}  // namespace tandem::fuzz
