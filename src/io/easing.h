#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

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

/// The share of the way at the share of time x in [0,1].
[[nodiscard]] double ease(const Easing& easing, double x);

/// Part of an easing as one of its own: it starts at the time `start`.
struct EasingPart {
  double start = 0.0;
  Easing easing;
};

/// The part that runs from the share `from` of the way to the share `to`, 0 <= from < to <= 1. A part of a
/// Bezier curve is one, so it is exact, but for rare controls beyond [0,1], which formats do not take: they
/// are moved to the bound.
[[nodiscard]] EasingPart part_of(const Easing& easing, double from, double to);

/// The easing of the same motion run backwards.
[[nodiscard]] Easing reversed(const Easing& easing);

/// "linear", "ease", "ease-in", "ease-out", "ease-in-out", or four numbers in [0,1] separated by blanks or
/// commas.
/// @throws InvalidArgument anything else
[[nodiscard]] Easing parse_easing(std::string_view text);

/// Easings separated by semicolons, as SMIL separates its keySplines: one, or one for each of `steps` steps.
/// @throws InvalidArgument another number of them, or as above
[[nodiscard]] std::vector<Easing> parse_easings(std::string_view text, std::size_t steps);

}  // namespace v0
}  // namespace tandem
