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
#include "match/vector.h"
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

/// Curves that are no further apart than this, as a share of their size, coincide: the tolerance within which
/// ends of closed curves meet.
constexpr double kCoincident = 1e-9;
/// The pull of strain on rulings that are to be developable, against its usual one.
constexpr double kDevelopableStrain = 1.0 / 20.0;
constexpr double kDevelopableTolerance = 1.0 / 16.0;
/// Warp that a fit may add: 0.05 degrees.
constexpr double kAddedWarp = 0.05 * std::numbers::pi / 180;
/// Pairs of points at which curves are compared.
constexpr int kComparisons = 64;

void check(const Curve& a, const Curve& b, const RuleOptions& options) {
  if (a.dim() != b.dim()) {
    throw InvalidArgument(fmt::format("the curves have different dimensions: the first has {}, the second {}",
                                      a.dim(), b.dim()));
  }
  if (a.dim() < 2) throw InvalidArgument("the curves lie on a line (dimension 1): no surface between them");
  if (a.is_closed() != b.is_closed() && options.match.closed != ClosedMode::no) {
    throw InvalidArgument(
        fmt::format("the first curve is {}, the second {}: a ruled surface needs two open or two closed "
                    "curves, or the closed one taken as open where its seam lies (ClosedMode::no)",
                    a.is_closed() ? "closed" : "open", b.is_closed() ? "closed" : "open"));
  }
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

void refuse_coincident(const Curve& a, const Curve& b) {
  const Interval domain = a.domain();
  for (int i = 0; i <= kComparisons; ++i) {
    const double u = domain.lo + domain.length() * i / kComparisons;
    if (detail::distance(a.evaluate(u), b.evaluate(u)) > kCoincident * std::max(a.extent(), b.extent()))
      return;
  }
  throw InvalidArgument("the two curves coincide: no surface between them");
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
  const bool projected = plane && a.dim() > 2;
  const Curve rail_a = projected ? detail::in_plane(a, *plane) : a;
  const Curve rail_b = projected ? detail::in_plane(b, *plane) : b;

  RailOptions rails = rail_options(options, plane.has_value());
  if (!plane && a.dim() == 3) {
    rails.creases = [&](const Curve& second, std::span<const double> corners) {
      return detail::find_crease(between(rail_a, second), corners).angle > options.largest_crease;
    };
  }
  PairedRails paired = detail::pair_rails(rail_a, rail_b, rails);

  const Curve second = paired.match.curve;
  refuse_coincident(rail_a, second);
  RuledReport report;
  report.planar = plane.has_value();
  report.norm = norm_name(options, report.planar, paired.match.report);
  report.tangents = check_validity(rail_a, second);
  report.validity = report.planar ? check_validity(rail_a, second, NormKind::ruled) : report.tangents;
  paired.match.report.validity = report.validity;
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
