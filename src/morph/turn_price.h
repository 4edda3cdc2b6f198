#pragma once

#include <cmath>

#include "morph/score.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Whether a turn of the whole by so many degrees is seen as one.
[[nodiscard]] inline bool turns_much(double degrees) {
  constexpr double kMuchTurned = 25.0;
  return std::fabs(degrees) > kMuchTurned;
}

/// What a detour costs in blemishes by the width of its smoothing, a share of the length.
[[nodiscard]] inline double width_price(double width) {
  constexpr double kWidthBlemish = 3.0;
  return kWidthBlemish * width;
}

/// Whether an upright step on a detour is better than one that turns: it has at most one in-between of
/// nineteen more that is at fault, which is less to be seen than a turn, and the detour, too, costs less.
[[nodiscard]] inline bool is_better_upright(const Score& upright, double width, const Score& turned) {
  constexpr double kDetourBlemish = 0.15;
  constexpr double kFaultBlemish = 0.4;
  const auto price = [](const Score& of) { return of.blemish + kFaultBlemish * of.faults; };
  return upright.faults <= turned.faults + 1 &&
         price(upright) + kDetourBlemish + width_price(width) < price(turned);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
