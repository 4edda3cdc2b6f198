#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "match/limit_slopes.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A scalar spline through (knots.front(), first) and (knots.back(), last), fitted to data.
struct ScalarFit {
  std::vector<double> coefficients;
  double deviation = 0.0;  ///< largest distance to the data; to the nearest value where several share one x
};

/// Least squares with the slopes of the control polygon (over the Greville abscissae) within a range, and so
/// those of the spline, whose derivative they are the coefficients of; exact, see solve_monotone().
///
/// x: non-decreasing, within the knots' domain; y: non-decreasing. knots: clamped, coefficients + degree + 1.
/// Beside the data there is a pull towards uniform speed, kStillness of the data's weight: it decides where
/// there are no data, and moves features of width w, a share of the domain [0,1], by (1e-6 / w)^2.
/// Data are expected in [0,1] x [0,1], where the mean slope is 1.
/// ends: slopes to be met exactly at the first and the last knot (of a spline that goes on there), within the
/// range; the spline needs a coefficient between the four that they fix.
struct EndSlopes {
  std::optional<double> first;
  std::optional<double> last;
};
[[nodiscard]] ScalarFit fit_scalar_spline(std::span<const double> x, std::span<const double> y,
                                          std::span<const double> knots, int degree, double first,
                                          double last, const SlopeRange& range, const EndSlopes& ends = {});

}  // namespace detail
}  // namespace v0
}  // namespace tandem
