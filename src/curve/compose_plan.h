#pragma once

#include <cstddef>
#include <vector>

#include "curve/spline.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A knot of a composed curve: a break of the inner function, the inverse image of one of the outer curve, or
/// both.
struct Cut {
  double u = 0.0;       ///< parameter of the result
  double before = 0.0;  ///< value of the inner function at the end of the segment to the left
  double after = 0.0;   ///< and at the start of the one to the right; differs where outer knots coincide in u
  int smoothness = 0;   ///< continuous derivatives of the result there; 0 is a corner
  std::size_t inner = 0;  ///< piece of the inner function to the right
  std::size_t outer = 0;  ///< piece of the outer curve to the right
};

/// Where the composition outer(inner(u)) breaks: first and last cut are the ends of the domain of `inner`.
///
/// Both are given as Bezier pieces, `outer` only by its degree and breaks. A break of `inner` whose value is
/// a knot of `outer`, within 1e-12 of its domain, takes that very value (where it makes a corner: else the
/// rounding does not matter, and smooth pieces stay what they are).
/// @throws InvalidArgument inner is not increasing, or leaves the domain of outer
[[nodiscard]] std::vector<Cut> plan_cuts(int outer_degree, const std::vector<Break>& outer,
                                         const Pieces& inner);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
