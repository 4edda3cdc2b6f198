#include "tandem/surface/hermite_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "match/second_curve.h"
#include "surface/check_rails.h"
#include "surface/measure_rulings.h"
#include "surface/pair_rails.h"
#include "tandem/curve/compatible.h"
#include "tandem/curve/compose.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"
#include "tandem/surface/edit.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::PairedRails;
using detail::RailOptions;

/// x + factor * y, of curves with one set of knots and weights.
Curve sum(const Curve& x, double factor, const Curve& y) {
  Points points = x.control_points();
  const std::span<const double> other = y.control_points().data();
  for (std::size_t i = 0; i < points.data().size(); ++i) points.data()[i] += factor * other[i];
  return Curve(x.degree(), x.knots(), std::move(points), x.weights());
}

/// The span of the other parameter next to the line at t, on the side that is kept.
Interval span_beside(const Surface& surface, Along across, double t, bool before) {
  const Interval domain = surface.domain(across);
  Interval span = before ? Interval{domain.lo, t} : Interval{t, domain.hi};
  for (const Knot& knot : distinct_knots(surface.knots(across))) {
    if (before && knot.value < t) span.lo = std::max(span.lo, knot.value);
    if (!before && knot.value > t) span.hi = std::min(span.hi, knot.value);
  }
  return span;
}

void check_rail(const Rail& rail, const char* which) {
  if (rail.curve.dim() != rail.tangents.dim()) {
    throw InvalidArgument(fmt::format("the {} rail has dimension {}, its tangents {}", which,
                                      rail.curve.dim(), rail.tangents.dim()));
  }
  const Interval a = rail.curve.domain();
  const Interval b = rail.tangents.domain();
  if (!(a == b)) {
    throw InvalidArgument(
        fmt::format("the {} rail runs over [{}, {}], its tangents over [{}, {}]; expected the same domain",
                    which, a.lo, a.hi, b.lo, b.hi));
  }
}

/// A rail and its tangents as one curve, of twice the dimension: what happens to one happens to both.
Curve stacked(const Rail& rail) {
  const std::vector<Curve> both = with_common_denominator(std::array<Curve, 2>{rail.curve, rail.tangents});
  const auto dim = static_cast<std::size_t>(rail.curve.dim());
  Points points(2 * rail.curve.dim(), both[0].size());
  for (std::size_t i = 0; i < both[0].size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const auto from = both[k].control_points()[i];
      std::copy(from.begin(), from.end(), points[i].begin() + static_cast<std::ptrdiff_t>(k * dim));
    }
  }
  return Curve(both[0].degree(), both[0].knots(), std::move(points), both[0].weights());
}

/// The first or the second half of the coordinates.
Curve half(const Curve& both, std::size_t which) {
  const auto dim = static_cast<std::size_t>(both.dim()) / 2;
  Points points(both.dim() / 2, both.size());
  for (std::size_t i = 0; i < both.size(); ++i) {
    const auto from = both.control_points()[i].subspan(which * dim, dim);
    std::copy(from.begin(), from.end(), points[i].begin());
  }
  return Curve(both.degree(), both.knots(), std::move(points), both.weights());
}

/// The second rail and its tangents in step.
Rail in_step(const Rail& second, const Correspondence& correspondence, const Reparametrization& law) {
  const Curve both = stacked(second);
  if (correspondence.closed && !both.is_closed()) {
    throw InvalidArgument("the second rail is closed, but its tangents do not end as they start");
  }
  const Curve composed = compose(detail::second_curve(both, correspondence, law), law.v);
  return {half(composed, 0), half(composed, 1)};
}

/// The blend of rails over one domain.
Surface hermite(const Rail& first, const Rail& second) {
  const std::vector<Curve> all = with_common_denominator(
      std::array<Curve, 4>{first.curve, first.tangents, second.tangents, second.curve});
  const std::array<Curve, 4> rows = {all[0], sum(all[0], 1.0 / 3.0, all[1]), sum(all[3], -1.0 / 3.0, all[2]),
                                     all[3]};
  return Surface::of_rows(rows, 3, {0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0});
}

RailOptions rail_options(const HermiteOptions& options) {
  RailOptions rails;
  rails.match = options.match;
  rails.law = options.law;
  rails.strain = options.match.elastic.lambda;
  rails.refinement = detail::tangent_rail_norm();
  rails.defect = [](const Curve& first, const Curve& second) {
    return detail::invalidity(check_validity(first, second));
  };
  return rails;
}

}  // namespace

Rail rail_of(const Surface& surface, Along along, double t, Departure departure, double fullness) {
  const Along across = along == Along::u ? Along::v : Along::u;
  const Interval domain = surface.domain(across);
  if (!domain.contains(t)) {
    throw InvalidArgument(
        fmt::format("the line at {} lies outside the domain [{}, {}]", t, domain.lo, domain.hi));
  }
  if (!(fullness > 0.0)) throw InvalidArgument(fmt::format("the fullness is {}, expected > 0", fullness));
  // On the boundary there is only one side.
  const bool before = t > domain.lo && (departure == Departure::onwards || t >= domain.hi);
  const Interval span = span_beside(surface, across, t, before);
  const Surface strip = part_of(surface, across, span);

  // In Bezier form the derivative at an end is degree / length * (second row - first row); the rows of a
  // rational surface are rational curves themselves, whose difference is parallel to the derivative.
  const std::size_t rows = strip.size(across);
  const auto row = [&](std::size_t k) {
    Points points(strip.dim(), strip.size(along));
    std::vector<double> weights;
    for (std::size_t i = 0; i < strip.size(along); ++i) {
      const std::size_t index = along == Along::u ? i * rows + k : k * strip.size(along) + i;
      std::copy(strip.control_points()[index].begin(), strip.control_points()[index].end(),
                points[i].begin());
      if (strip.is_rational()) weights.push_back(strip.weights()[index]);
    }
    return Curve(strip.degree(along), strip.knots(along), std::move(points), std::move(weights));
  };
  const Curve edge = row(before ? rows - 1 : 0);
  const Curve next = row(before ? rows - 2 : 1);
  const double towards_growing = before ? -1.0 : 1.0;
  const double sign = departure == Departure::onwards ? 1.0 : -1.0;
  const double factor =
      fullness * sign * towards_growing * static_cast<double>(strip.degree(across)) / span.length();
  const std::vector<Curve> pair = with_common_denominator(std::array<Curve, 2>{next, edge});
  Curve difference = sum(pair[0], -1.0, pair[1]);
  Points vectors = difference.control_points();
  for (double& x : vectors.data()) x *= factor;
  return {edge, Curve(difference.degree(), difference.knots(), std::move(vectors), difference.weights())};
}

HermiteSurface blend_rails(const Rail& first, const Rail& second, const HermiteOptions& options) {
  check_rail(first, "first");
  check_rail(second, "second");
  detail::check_rails(first.curve, second.curve, options.match.closed, "a blend surface");
  if (!(options.largest_crease >= 0.0)) throw InvalidArgument("the largest crease must be an angle >= 0");
  detail::refuse_coincident(first.curve, second.curve);

  RailOptions rails = rail_options(options);
  if (first.curve.dim() == 3) {
    rails.creases = [&](const detail::RailInStep& tried) {
      const Surface surface = hermite(first, in_step(second, tried.correspondence, tried.law));
      return detail::find_crease(surface, tried.corners).angle > options.largest_crease;
    };
  }
  PairedRails paired = detail::pair_rails(first.curve, second.curve, rails);
  Match& match = paired.match;

  Surface surface = hermite(first, in_step(second, match.correspondence, match.reparametrization));
  if (match.report.cancelled) return {std::move(surface), std::move(match), {}};
  HermiteReport report;
  report.validity = check_validity(first.curve, match.curve);
  match.report.validity = report.validity;
  report.rulings = detail::measure_rulings(first.curve, match.curve);
  report.law = paired.law;
  const detail::Crease crease = detail::find_crease(surface, paired.corners);
  report.crease_angle = crease.angle;
  report.crease_u = crease.u;
  return {std::move(surface), std::move(match), std::move(report)};
}

}  // namespace v0
}  // namespace tandem
