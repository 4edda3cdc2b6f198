#include "shape/cubic_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "shape/third.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace {

// Where a cubic is compared with its curve, and the share of the tolerance allowed there: the error of
// Hermite interpolation goes like t^2 (1-t)^2, so seven places see more than 0.9 of its maximum on a short
// span.
constexpr int kProbes = 7;
constexpr double kProbeShare = 0.9;

// Error of an evaluated coordinate, relative to the largest one: a few dozen roundings.
constexpr double kRounding = 1e-14;

// A span is halved at most so often: 2^-16 of a span is far below anything drawn, and hostile weights must
// end.
constexpr int kMostHalvings = 16;

void append(Points& points, std::span<const std::array<double, 4>> cubic) {
  const std::size_t dim = cubic.size();
  std::vector<double> row(dim);
  for (std::size_t k = points.empty() ? 0 : 1; k < 4; ++k) {
    for (std::size_t d = 0; d < dim; ++d) row[d] = cubic[d][k];
    points.push_back(row);
  }
}

// One coordinate of a Bezier segment of degree 1..3 as a cubic.
std::array<double, 4> elevate(const Points& bezier, std::size_t d) {
  const auto p = [&](std::size_t i) { return bezier[i][d]; };
  switch (bezier.size()) {
    case 2:
      return {p(0), third(p(0), p(1)), third(p(1), p(0)), p(1)};
    case 3:
      return {p(0), third(p(1), p(0)), third(p(1), p(2)), p(2)};
    default:
      return {p(0), p(1), p(2), p(3)};
  }
}

Points elevate(const Curve& curve) {
  Points points;
  std::vector<std::array<double, 4>> cubic(static_cast<std::size_t>(curve.dim()));
  for (const Curve& segment : bezier_segments(curve)) {
    for (std::size_t d = 0; d < cubic.size(); ++d) cubic[d] = elevate(segment.control_points(), d);
    append(points, cubic);
  }
  return points;
}

std::vector<std::array<double, 4>> hermite(const Curve& curve, double lo, double hi) {
  const Points a = curve.derivatives(lo, 1, Side::right);
  const Points b = curve.derivatives(hi, 1, Side::left);
  const double h = (hi - lo) / 3.0;
  std::vector<std::array<double, 4>> cubic(static_cast<std::size_t>(curve.dim()));
  for (std::size_t d = 0; d < cubic.size(); ++d) {
    cubic[d] = {a[0][d], a[0][d] + h * a[1][d], b[0][d] - h * b[1][d], b[0][d]};
  }
  return cubic;
}

bool follows(const std::vector<std::array<double, 4>>& cubic, const Curve& curve, double lo, double hi,
             double tolerance) {
  for (int i = 1; i <= kProbes; ++i) {
    const double t = static_cast<double>(i) / (kProbes + 1);
    const Point want = curve.evaluate(lo + t * (hi - lo));
    const double u = 1.0 - t;
    for (std::size_t d = 0; d < cubic.size(); ++d) {
      const auto& c = cubic[d];
      const double x = u * u * u * c[0] + 3 * t * u * u * c[1] + 3 * t * t * u * c[2] + t * t * t * c[3];
      if (!(std::fabs(x - want[d]) <= tolerance)) return false;
    }
  }
  return true;
}

/// The cubics of several curves, and where they begin.
struct Fit {
  std::vector<Points> points;
  std::vector<double> breaks;
};

void fit_span(std::span<const Curve> curves, double lo, double hi, double tolerance, int halvings,
              Fit& result) {
  std::vector<std::vector<std::array<double, 4>>> cubics;
  bool good = true;
  for (const Curve& curve : curves) {
    cubics.push_back(hermite(curve, lo, hi));
    good = good && follows(cubics.back(), curve, lo, hi, tolerance);
  }
  const double middle = lo + (hi - lo) / 2.0;
  if (!good && halvings > 0 && lo < middle && middle < hi) {
    fit_span(curves, lo, middle, tolerance, halvings - 1, result);
    fit_span(curves, middle, hi, tolerance, halvings - 1, result);
    return;
  }
  for (std::size_t i = 0; i < curves.size(); ++i) append(result.points[i], cubics[i]);
  result.breaks.push_back(hi);
}

bool is_exact(const Curve& curve) {
  return curve.degree() <= 3 && !curve.is_rational();
}

Fit fit(std::span<const Curve> curves, double tolerance) {
  Fit result;
  result.points.resize(curves.size());
  double largest = 0.0;
  for (const Curve& curve : curves) {
    for (double x : curve.control_points().data()) largest = std::max(largest, std::fabs(x));
  }
  // Tolerances count distances, probes compare coordinates; below rounding nothing can be met.
  const double share = std::max(
      kProbeShare * tolerance / std::sqrt(static_cast<double>(curves.front().dim())), kRounding * largest);
  const Interval domain = curves.front().domain();
  const std::vector<Knot> knots = distinct_knots(curves.front().knots());
  result.breaks.push_back(domain.lo);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    if (knots[i].value < domain.lo || knots[i + 1].value > domain.hi) continue;
    fit_span(curves, knots[i].value, knots[i + 1].value, share, kMostHalvings, result);
  }
  return result;
}

}  // namespace

std::vector<Points> cubic_control_points(std::span<const Curve> curves, double tolerance) {
  if (!std::all_of(curves.begin(), curves.end(), is_exact)) return fit(curves, tolerance).points;
  std::vector<Points> result;
  for (const Curve& curve : curves) result.push_back(elevate(curve));
  return result;
}

std::vector<double> cubic_breaks(const Curve& curve, double tolerance) {
  if (!is_exact(curve)) return fit({&curve, 1}, tolerance).breaks;
  std::vector<double> breaks;
  for (const Curve& segment : bezier_segments(curve)) breaks.push_back(segment.domain().lo);
  breaks.push_back(curve.domain().hi);
  return breaks;
}

}  // namespace v0
}  // namespace tandem
