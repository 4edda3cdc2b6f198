#pragma once

#include <string_view>

namespace tandem {
inline namespace v0 {

/// A CSS timing function: the Bezier curve (0,0) (x1,y1) (x2,y2) (1,1).
struct Easing {
  double x1 = 0.0;
  double y1 = 0.0;
  double x2 = 1.0;
  double y2 = 1.0;

  [[nodiscard]] bool linear() const noexcept { return x1 == y1 && x2 == y2; }
};

/// "linear", "ease", "ease-in", "ease-out", "ease-in-out", or four numbers in [0,1] separated by blanks or
/// commas.
/// @throws InvalidArgument anything else
[[nodiscard]] Easing parse_easing(std::string_view text);

}  // namespace v0
}  // namespace tandem
