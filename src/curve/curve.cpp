#include "tandem/curve/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "curve/check_spline.h"
#include "curve/evaluator.h"
#include "curve/norm.h"
#include "curve/scratch.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// Ends within this share of the size meet (docs: interface, "A curve whose ends meet ...").
constexpr double kClosedTolerance = 1e-9;

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
  detail::check_knots(degree_, knots_);
  detail::check_points(control_points_);
  detail::check_weights(weights_);
  extent_ = detail::box_diagonal(control_points_);
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
