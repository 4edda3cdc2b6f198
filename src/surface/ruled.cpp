#include "tandem/surface/ruled.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "match/second_curve.h"
#include "surface/check_rails.h"
#include "surface/measure_rulings.h"
#include "surface/pair_rails.h"
#include "surface/plane.h"
#include "tandem/curve/compatible.h"
#include "tandem/curve/compose.h"
#include "tandem/error.h"
#include "tandem/surface/developable.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::PairedRails;
using detail::Plane;
using detail::RailOptions;

/// The pull of strain on rulings that are to be developable, against its usual one.
constexpr double kDevelopableStrain = 1.0 / 20.0;
constexpr double kDevelopableTolerance = 1.0 / 16.0;
/// Warp that a fit may add: 0.05 degrees.
constexpr double kAddedWarp = 0.05 * std::numbers::pi / 180;

void check(const Curve& a, const Curve& b, const RuleOptions& options) {
  detail::check_rails(a, b, options.match.closed, "a ruled surface");
  if (!(options.largest_crease >= 0.0)) throw InvalidArgument("the largest crease must be an angle >= 0");
  if (!(options.largest_inclination > 0.0 && options.largest_inclination <= 0.5 * std::numbers::pi)) {
    throw InvalidArgument(fmt::format("the largest inclination is {} rad, expected one in (0, pi/2]",
                                      options.largest_inclination));
  }
  if (!options.developable && options.largest_inclination < 0.5 * std::numbers::pi) {
    throw InvalidArgument("a largest inclination goes with developable surfaces only");
  }
}

/// The plane of both curves, if they have one.
std::optional<Plane> plane_of(const Curve& a, const Curve& b, const RuleOptions& options) {
  const std::array<Curve, 2> both = {a, b};
  std::optional<Plane> plane = detail::common_plane(both);
  if (plane && plane->is_line) throw InvalidArgument("both curves lie on one line: no surface between them");
  if (!plane && options.planar) {
    throw InvalidArgument("the curves do not lie in one plane, within 1e-9 of their size");
  }
  return plane;
}

RailOptions rail_options(const RuleOptions& options, bool planar) {
  RailOptions rails;
  rails.match = options.match;
  rails.law = options.law;
  rails.strain = options.match.elastic.lambda;
  const NormKind test = planar ? NormKind::ruled : NormKind::tangent;
  rails.defect = [test](const Curve& first, const Curve& second) {
    return detail::invalidity(check_validity(first, second, test));
  };
  rails.refinement = planar ? detail::planar_rail_norm(1.0) : detail::space_rail_norm();
  if (planar) rails.flipped = detail::planar_rail_norm(-1.0);
  if (options.norm) {
    rails.match.norm = *options.norm;
  } else if (planar) {
    rails.match.norm = NormKind::ruled;
  } else {
    rails.match.norm = detail::space_norm();
  }
  if (options.developable) {
    rails.match.norm = developable_norm(options.largest_inclination);
    rails.match.elastic.lambda *= kDevelopableStrain;
    rails.strain = rails.match.elastic.lambda;
    rails.refinement = detail::developable_rail_norm(options.largest_inclination);
    rails.flipped = nullptr;
    rails.law.tolerance *= kDevelopableTolerance;
    rails.defect = [limit = options.largest_inclination](const Curve& first, const Curve& second) {
      const RulingReport report = detail::measure_rulings(first, second);
      return report.mean_warp_angle + std::max(0.0, report.inclination - limit);
    };
    rails.slack = kAddedWarp;
  }
  return rails;
}

std::string norm_name(const RuleOptions& options, bool planar, const MatchReport& report) {
  if (options.developable) return "developable";
  if (options.norm) return report.norm;
  return planar ? "ruled" : "anti-twist";
}

/// The ruled surface between curves over one domain.
Surface between(const Curve& first, const Curve& second) {
  const std::vector<Curve> rails = with_common_denominator(std::array<Curve, 2>{first, second});
  return Surface::of_rows(rails, 1, {0.0, 0.0, 1.0, 1.0});
}

/// The match, of curves in their plane, with the curves themselves.
Match in_space(Match match, const Curve& b) {
  const Correspondence& c = match.correspondence;
  match.curve = compose(detail::second_curve(b, c, match.reparametrization), match.reparametrization.v);
  return match;
}

}  // namespace

RuledSurface rule(const Curve& a, const Curve& b, const RuleOptions& options) {
  check(a, b, options);
  const std::optional<Plane> plane = plane_of(a, b, options);
  detail::refuse_coincident(a, b);
  const bool projected = plane && a.dim() > 2;
  const Curve rail_a = projected ? detail::in_plane(a, *plane) : a;
  const Curve rail_b = projected ? detail::in_plane(b, *plane) : b;

  RailOptions rails = rail_options(options, plane.has_value());
  if (!plane && a.dim() == 3) {
    rails.creases = [&](const detail::RailInStep& tried) {
      return detail::find_crease(between(rail_a, tried.curve), tried.corners).angle > options.largest_crease;
    };
  }
  PairedRails paired = detail::pair_rails(rail_a, rail_b, rails);

  const Curve second = paired.match.curve;
  if (paired.match.report.cancelled) return {between(rail_a, second), std::move(paired.match), {}};
  RuledReport report;
  report.planar = plane.has_value();
  report.norm = norm_name(options, report.planar, paired.match.report);
  report.tangents = check_validity(rail_a, second);
  report.validity = report.planar ? check_validity(rail_a, second, NormKind::ruled) : report.tangents;
  paired.match.report.validity = report.validity;
  paired.match.report.norm = report.norm;
  report.law = paired.law;
  report.rulings = detail::measure_rulings(rail_a, second);
  if (report.planar && !report.validity.valid) {
    report.wrong_sign_share = detail::wrong_sign_share(rail_a, second);
  }
  if (projected) paired.match = in_space(std::move(paired.match), b);
  Surface surface = between(a, paired.match.curve);
  if (!report.planar) {
    const detail::Crease crease = detail::find_crease(surface, paired.corners);
    report.rulings.crease_angle = crease.angle;
    report.rulings.crease_u = crease.u;
  }
  return {std::move(surface), std::move(paired.match), std::move(report)};
}

}  // namespace v0
}  // namespace tandem
