#pragma once

#include "tandem/match/reparametrization.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// How v(u) of a surface is made from a path.
struct LawOptions {
  /// Order (degree + 1) of v: 4 is C2, 3 is C1; 2 is piecewise linear, which creases a surface in space.
  int order = 4;
  /// Largest |v(u) - path| allowed, as a share of v's domain.
  double tolerance = 1e-3;
  /// Slopes of v, relative to the mean slope, stay within [min_slope, 1 / min_slope].
  double min_slope = 1e-3;
};

/// A strictly increasing v(u) without creases over [first u, last u] of the path: the constrained
/// least-squares fit from corner to corner, with knots where they are needed: spans are halved where the fit
/// is not within the tolerance, down to 1/16384 of the domain.
///
/// v is C^(order-2) but for the path's corners, where it is C0. loop: the path is one period, and v runs on
/// smoothly (C1) across the seam, unless that is a corner. Order 2: fit(). As with fit(), the tolerance may
/// be missed where the slopes forbid it; max_deviation tells.
/// @throws InvalidArgument as fit()
[[nodiscard]] TANDEM_EXPORT Reparametrization smooth_law(const FitPath& path, const LawOptions& options = {},
                                                         bool loop = false, bool reversed = false);

/// What became of the law that was asked for.
enum class LawOutcome {
  as_asked,
  finer,        ///< a smaller tolerance, to keep the surface valid
  lower_order,  ///< a lower order, to keep the surface valid: 2 creases it
  least_bad,    ///< no law keeps the surface valid: the one with the least invalid length
  /// The order that was asked for, further from the path than the tolerance: the slopes allowed, or spans as
  /// short as they may be, keep it from coming nearer. max_deviation tells.
  beyond_tolerance,
};

/// How the law of a surface was made.
struct LawReport {
  LawOutcome outcome = LawOutcome::as_asked;
  int order = 4;             ///< of the law taken
  double tolerance = 1e-3;   ///< that it was fitted to
  double max_deviation = 0;  ///< from the path, as a share of v's domain
  bool refined = false;      ///< the path was looked for once more, on finer nodes beside the first one
};

}  // namespace v0
}  // namespace tandem
