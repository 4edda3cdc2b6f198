#pragma once

#include "curve/spline.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Checks that a scalar function, given as Bezier pieces, never decreases within a piece by more than `slack`
/// (absolute, for rounding). @throws InvalidArgument it does, with the place
void check_increasing(const Pieces& function, double slack);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
