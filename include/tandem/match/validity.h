#pragma once

#include "tandem/curve/curve.h"
#include "tandem/match/norm.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// What [C] Definition 5 says of two curves that run in step over one domain.
struct Validity {
  bool valid = false;        ///< the value is > 0 throughout (one-sided at corners), no corner backtracks
  double min_dot = 0.0;      ///< the smallest value found
  double mean_dot = 0.0;     ///< its mean over the length (mean of both curves')
  double valid_share = 0.0;  ///< share of the length (mean of both curves) on which it is > 0
  double worst_u = 0.0;      ///< where min_dot was found
};

/// Checks a(u) against b(u) in the tangent or ruled norm (other norms have no validity: the tangent norm is
/// used).
///
/// The value is <T1,T2>; in the ruled norm <T1,T2> - <T1,d><T2,d>/|d|^2, d = b - a, and <T1,T2> where d = 0.
/// In the plane that is the product of d x T1 and d x T2 (d made a unit vector), and both must have one
/// global sign (spec C13): of the two signs the one with less invalid length is taken, and the value counts
/// as negative wherever a factor has the other one. Tangents where the speed is zero are one-sided limits; a
/// curve that stands still over a whole span has none, and the value is 1 there (spec C18).
///
/// Sampled on every span common to both, more densely where tangents turn far or the value is near a change
/// of sign, and the minimum sharpened. In the tangent norm no negative stretch longer than 1/8192 of a span
/// is missed: between samples the control points must certify the sign, or the samples are halved. Corners
/// are seen from both sides, the seam of two closed curves as well; and, in the plane, a pair of corners
/// whose blended turn passes pi is invalid although its tangents agree (spec C13): `valid` is false then,
/// while the other fields keep what the values say.
/// @throws InvalidArgument the dimensions or the domains differ
[[nodiscard]] TANDEM_EXPORT Validity check_validity(const Curve& a, const Curve& b,
                                                    NormKind norm = NormKind::tangent);

}  // namespace v0
}  // namespace tandem
