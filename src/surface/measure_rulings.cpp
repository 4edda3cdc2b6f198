#include "surface/measure_rulings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "curve/evaluator.h"
#include "match/vector.h"
#include "tandem/curve/knots.h"
#include "tandem/surface/developable.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Places looked at per span of either rail, one-sided at its ends.
constexpr int kPlaces = 8;
/// And per span in which the Jacobian changes sign at one of the two rails.
constexpr int kPlacesAtSign = 256;
/// Rulings across a possible crease: the ends and, as the normal turns along the ruling, places between.
constexpr int kRulings = 17;
/// Parameters this close, as a share of the domain, are the same: above the rounding of knots.
constexpr double kSameKnot = 1e-9;

/// Distinct breaks of both rails.
std::vector<double> common_breaks(const Curve& a, const Curve& b) {
  const Interval domain = a.domain();
  std::vector<double> breaks;
  for (const Curve* curve : {&a, &b}) {
    for (const double knot : curve->knots()) {
      if (domain.contains(knot)) breaks.push_back(knot);
    }
  }
  breaks.push_back(domain.lo);
  breaks.push_back(domain.hi);
  std::sort(breaks.begin(), breaks.end());
  const double same = kSameKnot * domain.length();
  const auto near = [same](double x, double y) { return y - x <= same; };
  breaks.erase(std::unique(breaks.begin(), breaks.end(), near), breaks.end());
  breaks.back() = domain.hi;
  return breaks;
}

/// Points and derivatives of both rails at one u.
class Rails {
 public:
  Rails(const Curve& a, const Curve& b)
      : a_(a), b_(b), dim_(static_cast<std::size_t>(a.dim())), numbers_(4 * dim_) {}

  void look(double u, Side side) {
    a_.point_and_derivative(u, side, row(0), row(2));
    b_.point_and_derivative(u, side, row(1), row(3));
  }

  /// The unit tangents, and their speeds in place of the derivatives.
  std::array<double, 2> normalize_tangents() { return {normalize(row(2)), normalize(row(3))}; }

  [[nodiscard]] NormArguments pair() { return {row(2), row(3), row(0), row(1)}; }

  /// The Jacobian of the ruled surface at both ends of the ruling, of planar rails.
  [[nodiscard]] std::array<double, 2> jacobian() {
    const std::array<double, 2> d = {row(1)[0] - row(0)[0], row(1)[1] - row(0)[1]};
    return {cross(row(2), d), cross(row(3), d)};
  }

 private:
  [[nodiscard]] std::span<double> row(std::size_t k) { return {numbers_.data() + k * dim_, dim_}; }

  Evaluator a_;
  Evaluator b_;
  std::size_t dim_;
  std::vector<double> numbers_;
};

/// Calls visit(u, side, weight) with the trapezoid rule's weights at `places` + 1 places from lo to hi.
template <class Visit>
void integrate(double lo, double hi, int places, const Visit& visit) {
  const double step = (hi - lo) / places;
  for (int i = 0; i <= places; ++i) {
    const bool end = i == 0 || i == places;
    visit(i == places ? hi : lo + step * i, i == places ? Side::left : Side::right, end ? 0.5 * step : step);
  }
}

/// Areas of both signs.
struct Areas {
  double positive = 0.0;
  double negative = 0.0;

  /// The integral over a ruling along which the Jacobian goes from `first` to `second` linearly.
  void add(double first, double second, double weight) {
    const double low = std::min(first, second);
    const double high = std::max(first, second);
    if (low >= 0.0) {
      positive += weight * 0.5 * (low + high);
    } else if (high <= 0.0) {
      negative -= weight * 0.5 * (low + high);
    } else {
      positive += weight * 0.5 * high * high / (high - low);
      negative += weight * 0.5 * low * low / (high - low);
    }
  }
};

double angle_between(const Point& x, const Point& y) {
  double difference = 0.0;
  double sum = 0.0;
  for (std::size_t c = 0; c < x.size(); ++c) {
    difference += (x[c] - y[c]) * (x[c] - y[c]);
    sum += (x[c] + y[c]) * (x[c] + y[c]);
  }
  // A surface without a normal on one side has no crease.
  if (largest(x) == 0.0 || largest(y) == 0.0) return 0.0;
  return 2.0 * std::atan2(std::sqrt(difference), std::sqrt(sum));
}

}  // namespace

RulingReport measure_rulings(const Curve& a, const Curve& b) {
  RulingReport report;
  Rails rails(a, b);
  const std::vector<double> breaks = common_breaks(a, b);
  double length = 0.0;
  double twisted = 0.0;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    integrate(breaks[i], breaks[i + 1], kPlaces, [&](double u, Side side, double weight) {
      rails.look(u, side);
      const auto [speed_a, speed_b] = rails.normalize_tangents();
      const Ruling ruling = ruling_of(rails.pair());
      const double way = weight * (speed_a + speed_b);
      length += way;
      report.mean_warp_angle += way * ruling.warp;
      report.mean_inclination += way * ruling.inclination;
      if (ruling.warp >= 0.5 * std::numbers::pi) twisted += way;
      report.warp_angle = std::max(report.warp_angle, ruling.warp);
      report.inclination = std::max(report.inclination, ruling.inclination);
    });
  }
  if (length > 0.0) {
    report.mean_warp_angle /= length;
    report.mean_inclination /= length;
    report.twisted_share = twisted / length;
  }
  return report;
}

Crease find_crease(const Surface& surface, std::span<const double> corners) {
  Crease crease;
  if (surface.dim() != 3) return crease;
  const Interval u_domain = surface.domain(Along::u);
  const Interval v_domain = surface.domain(Along::v);
  const auto is_corner = [&](double u) {
    return std::any_of(corners.begin(), corners.end(),
                       [&](double corner) { return std::fabs(corner - u) <= kSameKnot * u_domain.length(); });
  };
  const auto look = [&](double before, double after) {
    for (int j = 0; j < kRulings; ++j) {
      const double v = v_domain.lo + v_domain.length() * j / (kRulings - 1);
      const double angle = angle_between(surface.normal(before, v, {Side::left, Side::right}),
                                         surface.normal(after, v, {Side::right, Side::right}));
      if (angle > crease.angle) crease = {angle, after};
    }
  };
  for (const Knot& knot : distinct_knots(surface.knots(Along::u))) {
    const bool inside = u_domain.lo < knot.value && knot.value < u_domain.hi;
    if (inside && knot.multiplicity >= surface.degree(Along::u) && !is_corner(knot.value)) {
      look(knot.value, knot.value);
    }
  }
  if (surface.is_closed(Along::u) && !is_corner(u_domain.lo) && !is_corner(u_domain.hi)) {
    look(u_domain.hi, u_domain.lo);
  }
  return crease;
}

double wrong_sign_share(const Curve& a, const Curve& b) {
  Rails rails(a, b);
  const std::vector<double> breaks = common_breaks(a, b);
  Areas areas;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    Areas span;
    const auto visit = [&](double u, Side side, double weight) {
      rails.look(u, side);
      const auto [first, second] = rails.jacobian();
      span.add(first, second, weight);
    };
    integrate(breaks[i], breaks[i + 1], kPlaces, visit);
    if (span.positive > 0.0 && span.negative > 0.0) {
      span = {};
      integrate(breaks[i], breaks[i + 1], kPlacesAtSign, visit);
    }
    areas.positive += span.positive;
    areas.negative += span.negative;
  }
  const double all = areas.positive + areas.negative;
  return all > 0.0 ? std::min(areas.positive, areas.negative) / all : 0.0;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
