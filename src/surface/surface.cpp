#include "tandem/surface/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "curve/check_spline.h"
#include "curve/norm.h"
#include "surface/surface_evaluator.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// Edges within this share of the size meet, as the ends of a curve do.
constexpr double kClosedTolerance = 1e-9;
// Partial derivatives whose product is this small, relative to their lengths, span no plane; and so far
// inside, as a share of the domain, the limit is taken then.
constexpr double kParallel = 1e-9;
constexpr double kInside = 1e-6;

constexpr const char* kNames[] = {"u", "v"};

void check(std::size_t along, int degree, const std::vector<double>& knots) {
  if (degree < 1) {
    throw InvalidArgument(
        fmt::format("the degree along {} is {}, expected at least 1", kNames[along], degree));
  }
  const std::size_t least = 2 * (static_cast<std::size_t>(degree) + 1);
  if (knots.size() < least) {
    throw InvalidArgument(fmt::format("{} knots along {} are too few for degree {}, expected at least {}",
                                      knots.size(), kNames[along], degree, least));
  }
  try {
    detail::check_knots(degree, knots);
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(fmt::format("along {}: {}", kNames[along], error.what()));
  }
}

void check_parameters(double u, double v) {
  if (std::isnan(u) || std::isnan(v)) {
    throw InvalidArgument(fmt::format("the parameters are ({}, {}), expected numbers", u, v));
  }
}

// The unit vector along a x b; empty when they span no plane.
Point unit_product(std::span<const double> a, std::span<const double> b) {
  const double la = detail::scaled_norm(a);
  const double lb = detail::scaled_norm(b);
  if (!(la > 0.0 && lb > 0.0)) return {};
  Point n(3);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t d = (c + 1) % 3;
    const std::size_t e = (c + 2) % 3;
    n[c] = (a[d] / la) * (b[e] / lb) - (a[e] / la) * (b[d] / lb);
  }
  const double length = detail::scaled_norm(n);
  if (!(length > kParallel)) return {};
  for (double& x : n) x /= length;
  return n;
}

// A parameter that far inside the domain, on the side from which it is seen.
double moved_inside(Interval domain, double t, Side side) {
  const double step = kInside * domain.length();
  const double at = domain.clamp(t);
  const double moved = side == Side::right ? at + step : at - step;
  return domain.contains(moved) ? moved : 2.0 * at - moved;
}

}  // namespace

Surface::Surface(SurfaceDegree degree, SurfaceKnots knots, Points control_points, std::vector<double> weights)
    : degree_(degree),
      knots_(std::move(knots)),
      control_points_(std::move(control_points)),
      weights_(std::move(weights)) {
  for (std::size_t i = 0; i < 2; ++i) check(i, degree_[i], knots_[i]);
  const std::size_t m = size(Along::u);
  const std::size_t n = size(Along::v);
  if (control_points_.size() / n != m || control_points_.size() % n != 0) {
    throw InvalidArgument(fmt::format(
        "{} control points do not fit {} and {} knots of degrees {} and {}, expected {} x {}",
        control_points_.size(), knots_[0].size(), knots_[1].size(), degree_[0], degree_[1], m, n));
  }
  if (!weights_.empty() && weights_.size() != control_points_.size()) {
    throw InvalidArgument(fmt::format("{} weights for {} control points, expected one each", weights_.size(),
                                      control_points_.size()));
  }
  detail::check_points(control_points_);
  detail::check_weights(weights_);
  extent_ = detail::box_diagonal(control_points_);
  for (const Along along : {Along::u, Along::v}) closed_[index(along)] = extent_ > 0.0 && edges_meet(along);
}

Surface Surface::of_rows(std::span<const Curve> rows, int degree, std::vector<double> knots) {
  if (rows.empty()) throw InvalidArgument("a surface of no rows");
  const Curve& first = rows.front();
  const std::size_t n = rows.size();
  Points points(first.dim(), first.size() * n);
  std::vector<double> weights(first.is_rational() ? points.size() : 0);
  for (std::size_t j = 0; j < n; ++j) {
    const Curve& row = rows[j];
    if (row.degree() != first.degree() || row.knots() != first.knots() || row.dim() != first.dim() ||
        row.is_rational() != first.is_rational()) {
      throw InvalidArgument(fmt::format(
          "row {} differs from row 0 in degree, knots, dimension or kind; make_compatible() helps", j));
    }
    for (std::size_t i = 0; i < first.size(); ++i) {
      const auto from = row.control_points()[i];
      std::copy(from.begin(), from.end(), points[i * n + j].begin());
      if (row.is_rational()) weights[i * n + j] = row.weights()[i];
    }
  }
  return Surface({first.degree(), degree}, {first.knots(), std::move(knots)}, std::move(points),
                 std::move(weights));
}

// Checked at as many places as the edges have degrees of freedom, so that nothing in between can differ by
// much.
bool Surface::edges_meet(Along along) const {
  const Along across = along == Along::u ? Along::v : Along::u;
  const detail::SurfaceEvaluator evaluator(*this);
  const Interval domain = this->domain(along);
  const auto dim = static_cast<std::size_t>(this->dim());
  Point a(dim);
  Point b(dim);
  const std::size_t places = size(across) * static_cast<std::size_t>(degree(across) + 1);
  for (std::size_t i = 0; i <= places; ++i) {
    const Interval other = this->domain(across);
    const double t = other.lo + other.length() * static_cast<double>(i) / static_cast<double>(places);
    evaluator.point(along == Along::u ? domain.lo : t, along == Along::u ? t : domain.lo, a);
    evaluator.point(along == Along::u ? domain.hi : t, along == Along::u ? t : domain.hi, b);
    for (std::size_t c = 0; c < dim; ++c) a[c] -= b[c];
    if (detail::scaled_norm(a) > kClosedTolerance * extent_) return false;
  }
  return true;
}

Point Surface::evaluate(double u, double v) const {
  check_parameters(u, v);
  Point point(static_cast<std::size_t>(dim()));
  detail::SurfaceEvaluator(*this).point(u, v, point);
  return point;
}

Points Surface::derivatives(double u, double v, int order, SurfaceSides sides) const {
  check_parameters(u, v);
  if (order < 0) {
    throw InvalidArgument(fmt::format("the order of the derivatives is {}, expected at least 0", order));
  }
  const auto n = static_cast<std::size_t>(order);
  Points rows(dim(), (n + 1) * (n + 2) / 2);
  detail::SurfaceEvaluator(*this).derivatives(u, v, order, sides, rows.data());
  return rows;
}

Point Surface::normal(double u, double v, SurfaceSides sides) const {
  if (dim() != 3) throw InvalidArgument(fmt::format("a normal in dimension {}, expected 3", dim()));
  const Points here = derivatives(u, v, 1, sides);
  Point n = unit_product(here[1], here[2]);
  if (!n.empty()) return n;
  const Points inside = derivatives(moved_inside(domain(Along::u), u, sides.u),
                                    moved_inside(domain(Along::v), v, sides.v), 1, sides);
  n = unit_product(inside[1], inside[2]);
  return n.empty() ? Point(3, 0.0) : n;
}

}  // namespace v0
}  // namespace tandem
