#pragma once

#include <vector>

#include "tandem/match/reparametrization.h"

namespace tandem {
inline namespace v0 {
namespace detail {

struct SmoothLawOptions {
  double tolerance = 1e-3;  ///< largest |v(u) - path| wanted, as a share of v's range
  bool closed = false;      ///< v(u + period) = v(u) + period, smooth across the seam as well
  std::vector<double> pins = {};  ///< u at which the path is met exactly
};

/// A quadratic law near the path: strictly increasing and C1, except at the path's corners, which it meets
/// exactly and where it is C0 only.
///
/// Its coefficients are the path's values at the Greville abscissae: an increasing control polygon makes an
/// increasing spline (Schoenberg, variation diminishing), whatever the knots are. Spans are halved where the
/// path is missed by more than the tolerance, down to 1/1024 of the domain; max_deviation tells. A path that
/// stands still or steps is mixed with as much uniform speed as keeps slopes above 1e-3 of the mean. Pins
/// shift the coefficients beside them; where that would not leave them increasing, pins become corners.
[[nodiscard]] Reparametrization smooth_law(const FitPath& path, const SmoothLawOptions& options,
                                           bool reversed);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
