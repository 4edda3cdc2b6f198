#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "curve/spline.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// t in [lo, hi), its place within the period, snapped to a knot that it misses by rounding alone: the
// fraction of a turn that is cut off would otherwise leave a span of a few ulps.
double place_in_period(const Curve& curve, double t) {
  const Interval domain = curve.domain();
  double place = t;
  if (t < domain.lo || t >= domain.hi) {
    place = domain.lo + std::fmod(t - domain.lo, domain.length());
    if (place < domain.lo) place += domain.length();
  }
  const double magnitude = std::max({std::abs(t), std::abs(domain.lo), std::abs(domain.hi)});
  const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * magnitude;
  const auto next = std::lower_bound(curve.knots().begin(), curve.knots().end(), place);
  if (next != curve.knots().end() && *next - place <= rounding) place = *next;
  if (next != curve.knots().begin() && place - *(next - 1) <= rounding) place = *(next - 1);
  return place >= domain.hi || place < domain.lo ? domain.lo : place;
}

// A knot one period later; the start of the domain becomes its end exactly.
double next_turn(Interval domain, double knot) {
  return domain.hi + (knot - domain.lo);
}

// Two turns of a periodic spline: the first one's coefficients, and the same again.
detail::Spline two_turns(const detail::Spline& spline) {
  const auto p = static_cast<std::size_t>(spline.degree);
  const std::size_t turn = spline.size() - p;
  const Interval domain = spline.domain();
  detail::Spline twice = spline;
  twice.knots.resize(spline.size() + 1);
  twice.coefficients.resize(turn * static_cast<std::size_t>(spline.stride));
  for (std::size_t i = 0; i < turn + p; ++i) {
    const double* from = spline[i % turn];
    twice.coefficients.insert(twice.coefficients.end(), from, from + spline.stride);
  }
  for (std::size_t i = p + 1; i < spline.knots.size(); ++i)
    twice.knots.push_back(next_turn(domain, spline.knots[i]));
  return twice;
}

// The whole turn that starts at `place`, smooth where the periodic spline is.
detail::Spline turn_of_periodic(const detail::Spline& spline, double place) {
  return detail::part_of(two_turns(spline), {place, next_turn(spline.domain(), place)});
}

// The part after `place` and then the part before it; a corner in between, where the old seam was.
detail::Spline turn_of_clamped(const detail::Spline& spline, double place) {
  const Interval domain = spline.domain();
  if (place == domain.lo) return spline;
  detail::Spline turn = detail::part_of(spline, {place, domain.hi});
  const detail::Spline rest = detail::part_of(spline, {domain.lo, place});
  detail::append(turn, rest, domain.length());
  return turn;
}

}  // namespace

Curve move_seam(const Curve& closed, double t) {
  if (!closed.is_closed()) throw InvalidArgument("cannot move the seam: the curve is not closed");
  if (!std::isfinite(t)) throw InvalidArgument(fmt::format("cannot move the seam to {}", t));
  const double place = place_in_period(closed, t);
  const double period = closed.domain().length();
  const detail::Spline spline = detail::premultiplied(closed);
  detail::Spline turn = closed.is_periodic() ? turn_of_periodic(spline, place)
                                             : turn_of_clamped(detail::clamped(spline), place);
  const double shift = t - place;
  const double end = t + period;
  const std::size_t order = static_cast<std::size_t>(turn.degree) + 1;
  for (std::size_t i = 0; i < turn.knots.size(); ++i) {
    double& knot = turn.knots[i];
    knot = i < order ? t : (i >= turn.size() ? end : std::clamp(knot + shift, t, end));
  }
  return detail::euclidean(std::move(turn));
}

}  // namespace v0
}  // namespace tandem
