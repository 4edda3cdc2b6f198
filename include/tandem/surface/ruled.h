#pragma once

#include <numbers>
#include <optional>
#include <string>

#include "tandem/curve/curve.h"
#include "tandem/match/match.h"
#include "tandem/surface/law.h"
#include "tandem/surface/surface.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

struct RuleOptions {
  /// How the curves are matched. `norm` and `reduction` mean nothing: see `norm` and `law`.
  MatchOptions match = {};
  /// Empty: in the plane NormKind::ruled with the signed test, both signs tried; in space the anti-twist form
  /// of it as the cost, with pairs <T1,T2> < 0 as the invalid ones.
  std::optional<Norm> norm = {};
  /// As developable as possible: developable_norm() instead. With a strain of a twentieth of
  /// match.elastic.lambda, which otherwise would pull rulings together, and a law as near to the path as
  /// tolerance / 16.
  bool developable = false;
  /// With `developable`: rulings do not lean further than this, in radians, if that can be had.
  double largest_inclination = std::numbers::pi / 2;
  LawOptions law = {};
  /// Laws that crease the surface by more than this where neither curve has a corner, in radians, are taken
  /// only when all others leave it invalid. 1 degree: less is not seen in a shaded picture.
  double largest_crease = std::numbers::pi / 180;
  /// Only curves that lie in one plane will do.
  bool planar = false;
};

/// How good the rulings of a surface between two rails are; angles in radians.
struct RulingReport {
  double crease_angle = 0.0;  ///< largest jump of the normal where neither curve has a corner; 0 in the plane
  double crease_u = 0.0;      ///< and where
  double warp_angle = 0.0;    ///< see Ruling: the largest, and the mean over the length
  double mean_warp_angle = 0.0;
  double inclination = 0.0;  ///< the largest, and the mean over the length
  double mean_inclination = 0.0;
  double twisted_share = 0.0;  ///< share of the length on which the warp is pi/2 or more
};

/// What was found, on the final surface.
struct RuledReport {
  bool planar = false;  ///< dim 2, or all in one plane
  std::string norm;     ///< "ruled", "anti-twist", "developable", "tangent", "distance", "bottleneck", "user"
  /// In the plane of the signed ruled test, in space of <T1,T2>.
  Validity validity;
  Validity tangents;  ///< of <T1,T2>, in the plane as well
  /// In the plane: share of the area swept by the rulings on which the Jacobian has the sign of the smaller
  /// part.
  double wrong_sign_share = 0.0;
  RulingReport rulings;
  LawReport law;
};

/// A ruled surface, with curve A at v = 0, curve B in step at v = 1, and u along them over A's domain.
struct RuledSurface {
  Surface surface;
  Match match;  ///< of A and B; `curve` is the edge v = 1
  RuledReport report;
};

/// R(u, v) = (1 - v) A(u) + v B(v(u)), exact (spec C15c): degrees of A and of B times that of the law are
/// raised to the same, rational curves are brought over one denominator.
///
/// Curves in one plane of R^3 are matched there; the surface lies in that plane. Validity is what a
/// self-intersection needs to be absent locally, sampled; certify() proves it. A surface of no valid match is
/// returned all the same: the report tells.
/// @throws InvalidArgument the curves are of different dimensions or of dimension 1, one is closed and the
///         other is not (unless ClosedMode::no says that this does not matter), they do not lie in one plane
///         where `planar` asks for it, lie on one line, or coincide; an inclination or crease limit that is
///         no angle; and as match()
[[nodiscard]] TANDEM_EXPORT RuledSurface rule(const Curve& a, const Curve& b,
                                              const RuleOptions& options = {});

}  // namespace v0
}  // namespace tandem
