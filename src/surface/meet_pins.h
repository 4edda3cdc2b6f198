#pragma once

#include <optional>
#include <span>

#include "tandem/curve/curve.h"
#include "tandem/match/correspondence.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The law, increasing and as smooth as it was, through the pins (u in its domain, v in its range), which it
/// misses by little: each shifts the coefficients that count at it by what is missing there. Nothing where it
/// would not increase any more, or where pins share coefficients and disagree. loop: the law runs on
/// periodically, so that the coefficients at its ends stay.
[[nodiscard]] std::optional<Curve> meet_pins(const Curve& law, std::span<const ParameterPair> pins,
                                             bool loop);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
