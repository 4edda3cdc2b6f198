#pragma once

#include <numbers>

#include "tandem/curve/curve.h"
#include "tandem/match/match.h"
#include "tandem/surface/law.h"
#include "tandem/surface/ruled.h"
#include "tandem/surface/surface.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// An edge of a blend surface: where it starts or ends, and how it leaves or arrives there.
struct Rail {
  Curve curve;
  /// The derivative across the edge, in the direction from the first rail to the second, as a curve of
  /// vectors over the same domain as `curve`.
  Curve tangents;
};

/// Which way a blend leaves a surface.
enum class Departure {
  onwards,  ///< towards growing values of the parameter that is constant along the rail
  back,
};

/// The rail along a surface's line `along` at `t` of the other parameter: the iso-curve, and the surface's
/// derivative across it, taken towards `departure` and multiplied by `fullness`; exact. Of a rational surface
/// the derivative is scaled by a positive function (the ratio of two weight functions), which leaves the
/// tangent plane as it is.
///
/// As the second rail of a blend, departure is the way in which the blend runs when it arrives there.
/// Inside the domain, where the surface has a crease along the line, the derivative is that on the side which
/// is kept: before t for `onwards`, after it for `back`.
/// @throws InvalidArgument fullness is not > 0, t lies outside the domain
[[nodiscard]] TANDEM_EXPORT Rail rail_of(const Surface& surface, Along along, double t,
                                         Departure departure = Departure::onwards, double fullness = 1.0);

struct HermiteOptions {
  /// How the rails are matched. `norm` is the tangent norm unless said otherwise, which keeps the blend free
  /// of twist; `reduction` means nothing: see `law`.
  MatchOptions match = {};
  LawOptions law = {};
  double largest_crease = std::numbers::pi / 180;  ///< see RuleOptions
};

/// What was found, on the final surface.
struct HermiteReport {
  Validity validity;  ///< <T1,T2> of the rails in step
  double crease_angle = 0.0;
  double crease_u = 0.0;
  RulingReport rulings;  ///< of the straight lines between the rails
  LawReport law;
};

/// A cubic Hermite blend surface: the first rail at v = 0, the second in step at v = 1, u along them over the
/// first one's domain.
struct HermiteSurface {
  Surface surface;
  Match match;
  HermiteReport report;
};

/// S(u, v) = H0(v) C1(u) + H1(v) T1(u) + H2(v) T2(w(u)) + H3(v) C2(w(u)), the cubic Hermite functions H and
/// the law w of the matched rails (spec C15d); exact, in Bezier form along v.
///
/// Rails and tangents are reparametrised together, so that the blend meets tangents and tangent planes given
/// along both rails: C1 (G1) with surfaces that have those.
/// @throws InvalidArgument a rail and its tangents differ in dimension or domain, the rails differ in
///         dimension, one is closed and the other is not (unless ClosedMode::no), dimension 1, they
///         coincide; and as match()
[[nodiscard]] TANDEM_EXPORT HermiteSurface blend_rails(const Rail& first, const Rail& second,
                                                       const HermiteOptions& options = {});

}  // namespace v0
}  // namespace tandem
