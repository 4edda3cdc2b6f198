#pragma once

#include "tandem/curve/curve.h"
#include "tandem/match/norm.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// What [C] Definition 5 says of two curves that run in step over one domain.
struct Validity {
  bool valid =
      false;  ///< the norm's value is > 0 throughout (one-sided at corners), and no corner backtracks
  double min_dot = 0.0;      ///< the smallest value found
  double mean_dot = 0.0;     ///< its mean over the length
  double valid_share = 0.0;  ///< share of the length (mean of both curves) on which it is > 0
  double worst_u = 0.0;      ///< where min_dot was found
};

/// Checks a(u) against b(u) in the tangent or ruled norm (other norms have no validity: the tangent norm is
/// used).
///
/// Sampled on every span common to both, with the minimum sharpened; corners from both sides, and, in the
/// plane, a pair of corners whose blended turn passes pi is invalid although its tangents agree (spec C13).
/// @throws InvalidArgument the dimensions or the domains differ
[[nodiscard]] TANDEM_EXPORT Validity check_validity(const Curve& a, const Curve& b,
                                                    NormKind norm = NormKind::tangent);

}  // namespace v0
}  // namespace tandem
