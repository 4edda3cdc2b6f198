#include "tandem/curve/edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "curve/spline.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

void check_part(const Curve& curve, Interval part) {
  const Interval domain = curve.domain();
  if (!(part.lo < part.hi)) {
    throw InvalidArgument(fmt::format("the part [{}, {}] is empty", part.lo, part.hi));
  }
  if (!(domain.lo <= part.lo && part.hi <= domain.hi)) {
    throw InvalidArgument(fmt::format("the part [{}, {}] reaches outside the domain [{}, {}]", part.lo,
                                      part.hi, domain.lo, domain.hi));
  }
}

// Affine map of the knots that meets the ends of the new domain exactly and keeps equal knots equal.
std::vector<double> mapped_knots(const Curve& curve, Interval to) {
  const Interval from = curve.domain();
  std::vector<double> knots = curve.knots();
  for (double& knot : knots) {
    if (knot == from.hi) {
      knot = to.hi;
    } else {
      const bool inside = from.lo <= knot && knot <= from.hi;
      knot = to.lo + (knot - from.lo) / from.length() * to.length();
      if (inside) knot = to.clamp(knot);
    }
  }
  return knots;
}

}  // namespace

Curve insert_knot(const Curve& curve, double t, int times) {
  if (times < 0)
    throw InvalidArgument(fmt::format("knot {} inserted {} times, expected at least 0", t, times));
  return refine(curve, std::vector<double>(static_cast<std::size_t>(times), t));
}

Curve refine(const Curve& curve, std::span<const double> knots) {
  if (knots.empty()) return curve;
  const Interval domain = curve.domain();
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!domain.contains(knots[i])) {
      throw InvalidArgument(
          fmt::format("new knot {} lies outside the domain [{}, {}]", knots[i], domain.lo, domain.hi));
    }
    if (i > 0 && knots[i] < knots[i - 1]) {
      throw InvalidArgument(
          fmt::format("new knot {} is {}, before new knot {} ({})", i, knots[i], i - 1, knots[i - 1]));
    }
  }
  for (const Knot& knot : distinct_knots(knots)) {
    const int has = multiplicity(curve.knots(), knot.value);
    if (has + knot.multiplicity > curve.degree()) {
      throw InvalidArgument(
          fmt::format("knot {} stands {} times already, {} more would exceed the degree ({})", knot.value,
                      has, knot.multiplicity, curve.degree()));
    }
  }
  std::vector<double> all(curve.knots().size() + knots.size());
  std::merge(curve.knots().begin(), curve.knots().end(), knots.begin(), knots.end(), all.begin());
  return detail::euclidean(detail::over_knots(detail::premultiplied(curve), std::move(all)));
}

SplitCurve split(const Curve& curve, double t) {
  const Interval domain = curve.domain();
  if (!(domain.lo < t && t < domain.hi)) {
    throw InvalidArgument(
        fmt::format("cannot split at {}: not strictly inside the domain [{}, {}]", t, domain.lo, domain.hi));
  }
  const detail::Spline spline = detail::premultiplied(curve);
  return {detail::euclidean(detail::part_of(spline, {domain.lo, t})),
          detail::euclidean(detail::part_of(spline, {t, domain.hi}))};
}

Curve subcurve(const Curve& curve, Interval part) {
  check_part(curve, part);
  return detail::euclidean(detail::part_of(detail::premultiplied(curve), part));
}

Curve reverse(const Curve& curve) {
  const Interval domain = curve.domain();
  std::vector<double> knots(curve.knots().rbegin(), curve.knots().rend());
  for (double& knot : knots) {
    if (knot == domain.hi) {
      knot = domain.lo;
    } else {
      const bool inside = domain.contains(knot);
      knot = domain.hi + (domain.lo - knot);
      if (inside) knot = domain.clamp(knot);
    }
  }
  Points points(curve.dim(), curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const auto from = curve.control_points()[curve.size() - 1 - i];
    std::copy(from.begin(), from.end(), points[i].begin());
  }
  return Curve(curve.degree(), std::move(knots), std::move(points),
               std::vector<double>(curve.weights().rbegin(), curve.weights().rend()));
}

Curve with_domain(const Curve& curve, Interval domain) {
  if (!(domain.lo < domain.hi)) {
    throw InvalidArgument(fmt::format("the domain [{}, {}] is empty", domain.lo, domain.hi));
  }
  if (domain == curve.domain()) return curve;
  return Curve(curve.degree(), mapped_knots(curve, domain), curve.control_points(), curve.weights());
}

Curve clamp(const Curve& curve) {
  if (detail::is_clamped(curve)) return curve;
  return subcurve(curve, curve.domain());
}

std::vector<Curve> bezier_segments(const Curve& curve) {
  const detail::Pieces pieces = detail::decompose(detail::premultiplied(curve));
  const auto order = static_cast<std::size_t>(pieces.degree) + 1;
  std::vector<Curve> segments;
  segments.reserve(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    detail::Spline segment;
    segment.degree = pieces.degree;
    segment.stride = pieces.stride;
    segment.rational = pieces.rational;
    segment.scale = pieces.scale;
    segment.knots.assign(order, pieces.breaks[i].value);
    segment.knots.insert(segment.knots.end(), order, pieces.breaks[i + 1].value);
    segment.coefficients.assign(pieces[i], pieces[i] + pieces.piece_length());
    segments.push_back(detail::euclidean(std::move(segment)));
  }
  return segments;
}

}  // namespace v0
}  // namespace tandem
