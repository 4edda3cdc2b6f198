#include "tandem/curve/nearest_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tandem/curve/knots.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr int kPlacesPerDegree = 32;

/// Golden sections of an interval until nothing is left but rounding.
constexpr int kSections = 90;
constexpr double kGolden = 0.61803398874989484820;

double distance_at(const Curve& curve, double t, std::span<const double> point) {
  const Point p = curve.evaluate(t);
  double most = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) most = std::max(most, std::fabs(p[k] - point[k]));
  if (!(most > 0.0)) return 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double d = (p[k] - point[k]) / most;
    sum += d * d;
  }
  return most * std::sqrt(sum);
}

/// The least distance in [lo, hi], which has one dip.
NearestPoint narrow(const Curve& curve, std::span<const double> point, double lo, double hi) {
  double left = hi - kGolden * (hi - lo);
  double right = lo + kGolden * (hi - lo);
  double at_left = distance_at(curve, left, point);
  double at_right = distance_at(curve, right, point);
  for (int k = 0; k < kSections && lo < left && right < hi && left < right; ++k) {
    if (at_left <= at_right) {
      hi = right;
      right = left;
      at_right = at_left;
      left = hi - kGolden * (hi - lo);
      at_left = distance_at(curve, left, point);
    } else {
      lo = left;
      left = right;
      at_left = at_right;
      right = lo + kGolden * (hi - lo);
      at_right = distance_at(curve, right, point);
    }
  }
  return at_left <= at_right ? NearestPoint{left, at_left} : NearestPoint{right, at_right};
}

}  // namespace

NearestPoint nearest_point(const Curve& curve, std::span<const double> point) {
  if (point.size() != static_cast<std::size_t>(curve.dim())) {
    throw InvalidArgument(
        fmt::format("nearest point: the point has {} coordinates, expected {}", point.size(), curve.dim()));
  }
  if (!std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); })) {
    throw InvalidArgument("nearest point: a coordinate of the point is not finite");
  }
  const Interval domain = curve.domain();
  std::vector<NearestPoint> places;
  const int parts = kPlacesPerDegree * curve.degree();
  const std::vector<Knot> knots = distinct_knots(curve.knots());
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    if (knots[i].value < domain.lo || knots[i + 1].value > domain.hi) continue;
    for (int k = 0; k < parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      const double t = (1.0 - share) * knots[i].value + share * knots[i + 1].value;
      places.push_back({t, distance_at(curve, t, point)});
    }
  }
  places.push_back({domain.hi, distance_at(curve, domain.hi, point)});
  NearestPoint best = places.front();
  const auto offer = [&best](const NearestPoint& p) {
    if (p.distance < best.distance) best = p;
  };
  for (const NearestPoint& place : places) offer(place);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const NearestPoint& before = places[k > 0 ? k - 1 : k];
    const NearestPoint& after = places[std::min(k + 1, places.size() - 1)];
    if (places[k].distance > before.distance || places[k].distance > after.distance) continue;
    offer(narrow(curve, point, before.parameter, after.parameter));
  }
  return best;
}

}  // namespace v0
}  // namespace tandem
