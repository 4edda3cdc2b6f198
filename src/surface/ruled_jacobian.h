#pragma once

#include <array>
#include <optional>
#include <vector>

#include "surface/enclosed_spline.h"
#include "tandem/curve/curve.h"
#include "tandem/curve/interval.h"
#include "tandem/surface/certificate.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Two planar curves over one domain in a frame, between which a surface is ruled.
struct Rails {
  EnclosedSpline a;
  EnclosedSpline b;
  /// b - a, where it is a spline over the same knots: from the control points, which loses least.
  std::optional<EnclosedSpline> d;
  bool rational = false;       ///< both with weights, as the third number
  std::array<bool, 2> pole{};  ///< the rails start, end, in the same point: exactly
  bool closed = false;         ///< both are closed
};

/// a and b in R^2.
[[nodiscard]] Rails make_rails(const Curve& a, const Curve& b);

/// Where on which rail (0: a, 1: b) something was proved.
struct RailPlace {
  double u = 0.0;
  int rail = 0;
};

/// What is known of the sign of the Jacobian R_u x R_v of (1 - v) a(u) + v b(u).
struct JacobianSign {
  Verdict verdict = Verdict::undecided;
  /// +1 or -1: proved for all rulings but the ends, and on them all but points of the rails; that is enough
  /// for a map to be one-to-one where its boundary is simple. 0: not proved.
  int sign = 0;
  std::optional<RailPlace> positive;  ///< both when the sign changes; the rarer one is `rarer`
  std::optional<RailPlace> negative;
  int rarer = 0;                  ///< +1 or -1
  std::optional<RailPlace> zero;  ///< where the Jacobian is zero on a rail
};

/// The Jacobian is (1 - v) J_0(u) + v J_1(u), J_0 = a' x d, J_1 = b' x d, d = b - a: its sign is constant if
/// these two have one sign. (Rational curves, A = w a etc.: the determinants |A A' B| and |A B' B| of the
/// homogeneous points, which are J_0 and J_1 times powers of the positive weights.) As polynomials on each
/// span common to both curves they are bounded by their Bernstein coefficients, and halved where these do not
/// decide.
[[nodiscard]] JacobianSign ruled_jacobian_sign(const Rails& rails);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
