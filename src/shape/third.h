#pragma once

#include <cmath>

namespace tandem {
inline namespace v0 {

/// The point a third of the way: where the handle of a line stands. The difference of two huge numbers must
/// not overflow.
[[nodiscard]] inline double third(double from, double to) {
  const double d = to - from;
  return std::isfinite(d) ? from + d / 3.0 : from + (to / 3.0 - from / 3.0);
}

}  // namespace v0
}  // namespace tandem
