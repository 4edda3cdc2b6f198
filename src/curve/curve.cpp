#include "tandem/curve/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "curve/evaluator.h"
#include "curve/norm.h"
#include "curve/scratch.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// Sums and differences of a few numbers of this size still fit into a double.
constexpr double kLargest = 1e304;
// Products of several weights, and of weights with coordinates near 1, still fit.
constexpr double kLargestWeight = 1e100;
// Ends within this share of the size meet (docs: interface, "A curve whose ends meet ...").
constexpr double kClosedTolerance = 1e-9;

void check_number(double x, const char* what, std::size_t index) {
  if (!std::isfinite(x))
    throw InvalidArgument(fmt::format("{} {} is {}, expected a finite number", what, index, x));
  if (std::abs(x) > kLargest) {
    throw InvalidArgument(fmt::format("{} {} is {}, expected at most {} in size", what, index, x, kLargest));
  }
}

void check_sizes(int degree, std::size_t knots, std::size_t points, std::size_t weights) {
  if (degree < 1) throw InvalidArgument(fmt::format("the degree is {}, expected at least 1", degree));
  const std::size_t order = static_cast<std::size_t>(degree) + 1;
  if (points < order) {
    throw InvalidArgument(fmt::format("{} control points are too few for degree {}, expected at least {}",
                                      points, degree, order));
  }
  if (knots != points + order) {
    throw InvalidArgument(
        fmt::format("{} knots do not fit {} control points of degree {}, expected {} ({} + {} + 1)", knots,
                    points, degree, points + order, points, degree));
  }
  if (weights != 0 && weights != points) {
    throw InvalidArgument(
        fmt::format("{} weights for {} control points, expected one each", weights, points));
  }
}

void check_knots(int degree, const std::vector<double>& knots) {
  const auto p = static_cast<std::size_t>(degree);
  for (std::size_t i = 0; i < knots.size(); ++i) {
    check_number(knots[i], "knot", i);
    if (i > 0 && knots[i] < knots[i - 1]) {
      throw InvalidArgument(
          fmt::format("knot {} is {}, before knot {} ({})", i, knots[i], i - 1, knots[i - 1]));
    }
  }
  const double lo = knots[p];
  const double hi = knots[knots.size() - p - 1];
  if (!(hi - lo >= std::numeric_limits<double>::min())) {
    throw InvalidArgument(
        fmt::format("the domain [{}, {}] (knots {} and {}) is empty", lo, hi, p, knots.size() - p - 1));
  }
  for (std::size_t i = 0; i + p < knots.size(); ++i) {
    const bool interior = lo < knots[i] && knots[i] < hi;
    if (interior && knots[i + p] == knots[i]) {
      throw InvalidArgument(
          fmt::format("knot {} ({}) has a multiplicity above {}, the degree: the curve would break there", i,
                      knots[i], degree));
    }
    if (i + p + 1 < knots.size() && knots[i + p + 1] == knots[i]) {
      throw InvalidArgument(fmt::format("knot {} ({}) has a multiplicity above {}, the degree plus one", i,
                                        knots[i], degree + 1));
    }
  }
}

void check_points(const Points& points) {
  const auto dim = static_cast<std::size_t>(points.dim());
  const std::span<const double> data = points.data();
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (std::abs(data[i]) <= kLargest) continue;  // false for NaN
    check_number(data[i], fmt::format("coordinate {} of control point", i % dim).c_str(), i / dim);
  }
}

void check_weights(const std::vector<double>& weights) {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double w = weights[i];
    if (!(w > 0.0)) throw InvalidArgument(fmt::format("weight {} is {}, expected a positive number", i, w));
    if (!(1.0 / kLargestWeight <= w && w <= kLargestWeight)) {
      throw InvalidArgument(fmt::format("weight {} is {}, expected a number between {} and {}", i, w,
                                        1.0 / kLargestWeight, kLargestWeight));
    }
  }
}

double diagonal(const Points& points) {
  const std::size_t n = points.size();
  const auto dim = static_cast<std::size_t>(points.dim());
  const double* data = points.data().data();
  double largest = 0.0;
  double sum = 0.0;
  for (std::size_t c = 0; c < dim; ++c) {
    double lo = data[c];
    double hi = data[c];
    for (std::size_t i = 1; i < n; ++i) {
      lo = std::min(lo, data[i * dim + c]);
      hi = std::max(hi, data[i * dim + c]);
    }
    const double side = hi - lo;
    // Running scaled sum of squares, as in LAPACK's dnrm2.
    if (side > largest) {
      sum = 1.0 + sum * (largest / side) * (largest / side);
      largest = side;
    } else if (side > 0.0) {
      sum += (side / largest) * (side / largest);
    }
  }
  return largest * std::sqrt(sum);
}

bool ends_meet(const Curve& curve) {
  const auto dim = static_cast<std::size_t>(curve.dim());
  const detail::Evaluator evaluator(curve);
  detail::Scratch<16> ends(2 * dim);
  const std::span<double> a(ends.data(), dim);
  const std::span<double> b(ends.data() + dim, dim);
  evaluator.point(curve.domain().lo, a);
  evaluator.point(curve.domain().hi, b);
  for (std::size_t c = 0; c < dim; ++c) a[c] -= b[c];
  return detail::scaled_norm(a) <= kClosedTolerance * curve.extent();
}

bool repeats_itself(const Curve& curve) {
  const auto p = static_cast<std::size_t>(curve.degree());
  const std::size_t shift = curve.size() - p;
  const std::vector<double>& knots = curve.knots();
  const double period = curve.domain().length();
  const double rounding = 8.0 * std::numeric_limits<double>::epsilon() *
                          std::max(std::abs(knots.front()), std::abs(knots.back()));
  for (std::size_t i = 0; i <= 2 * p; ++i) {
    if (!(std::abs(knots[shift + i] - knots[i] - period) <= kClosedTolerance * period + rounding))
      return false;
  }
  const auto dim = static_cast<std::size_t>(curve.dim());
  std::vector<double> gap(dim);
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t c = 0; c < dim; ++c) {
      gap[c] = curve.control_points()[shift + i][c] - curve.control_points()[i][c];
    }
    if (detail::scaled_norm(gap) > kClosedTolerance * curve.extent()) return false;
    if (curve.is_rational() &&
        std::abs(curve.weights()[shift + i] - curve.weights()[i]) > kClosedTolerance * curve.weights()[i]) {
      return false;
    }
  }
  return true;
}

void check_parameter(double t) {
  if (std::isnan(t)) throw InvalidArgument("the parameter is nan, expected a number");
}

}  // namespace

Curve::Curve(int degree, std::vector<double> knots, Points control_points, std::vector<double> weights)
    : degree_(degree),
      knots_(std::move(knots)),
      control_points_(std::move(control_points)),
      weights_(std::move(weights)) {
  check_sizes(degree_, knots_.size(), control_points_.size(), weights_.size());
  check_knots(degree_, knots_);
  check_points(control_points_);
  check_weights(weights_);
  extent_ = diagonal(control_points_);
  if (extent_ > 0.0) {
    closed_ = ends_meet(*this);
    periodic_ = closed_ && repeats_itself(*this);
  }
}

Curve Curve::bezier(Points control_points, std::vector<double> weights, Interval domain) {
  const std::size_t n = control_points.size();
  if (n < 2)
    throw InvalidArgument(fmt::format("a Bezier curve of {} control points, expected at least 2", n));
  std::vector<double> knots(2 * n, domain.lo);
  std::fill(knots.begin() + static_cast<std::ptrdiff_t>(n), knots.end(), domain.hi);
  return Curve(static_cast<int>(n) - 1, std::move(knots), std::move(control_points), std::move(weights));
}

Curve Curve::clamped_uniform(int degree, Points control_points, std::vector<double> weights) {
  std::vector<double> knots = clamped_uniform_knots(degree, control_points.size());
  return Curve(degree, std::move(knots), std::move(control_points), std::move(weights));
}

Point Curve::evaluate(double t) const {
  check_parameter(t);
  Point point(static_cast<std::size_t>(dim()));
  detail::Evaluator(*this).point(t, point);
  return point;
}

Points Curve::derivatives(double t, int order, Side side) const {
  if (order < 0)
    throw InvalidArgument(fmt::format("the order of the derivative is {}, expected at least 0", order));
  check_parameter(t);
  Points rows(dim(), static_cast<std::size_t>(order) + 1);
  detail::Evaluator(*this).derivatives(t, order, side, rows.data());
  return rows;
}

}  // namespace v0
}  // namespace tandem
