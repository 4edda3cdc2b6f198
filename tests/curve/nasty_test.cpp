// Hostile curves through every function: each either works, with finite results, or refuses with
// InvalidArgument.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "tandem/curve/arc_length.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/curve/compatible.h"
#include "tandem/curve/compose.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"

namespace tandem {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kEps = std::numeric_limits<double>::epsilon();

rc::Gen<double> coordinate() {
  return rc::gen::weightedOneOf<double>(
      {{8, rc::gen::element(0.0, 1.0, -1.0, 0.5, 1.0 + kEps, 1.0 - kEps, 2.0, 1e-9)},
       {2, rc::gen::element(1e300, -1e300, 1e-300, -1e-300, 5e-324, 1e6, 1e6 + 1e-9, 1e150)},
       {1, rc::gen::map(rc::gen::inRange(-1000, 1000), [](int i) { return i / 128.0; })}});
}

// Mostly usable knots: clamped or not, with repeats and near repeats, near 0 or far away.
rc::Gen<std::vector<double>> knots_for(int degree, int interior) {
  return rc::gen::exec([=] {
    std::vector<double> knots;
    const bool clamped = *rc::gen::weightedElement<bool>({{3, true}, {1, false}});
    for (int i = 0; i <= degree; ++i) knots.push_back(clamped ? 0.0 : -0.25 * (i / 2));
    for (int i = 0; i < interior; ++i) {
      knots.push_back(
          *rc::gen::element(0.25, 0.5, 0.5, 0.5 + 1e-16, 0.5 + 1e-12, 0.5 + 1e-9, 0.75, 1e-300, 1.0 - kEps));
    }
    for (int i = 0; i <= degree; ++i) knots.push_back(clamped ? 1.0 : 1.0 + 0.25 * (i / 2));
    std::sort(knots.begin(), knots.end());
    const auto [offset, scale] = *rc::gen::elementOf(std::vector<std::pair<double, double>>{
        {0.0, 1.0}, {0.0, 1.0}, {1e6, 1.0}, {-1e15, 3.0}, {0.0, 1e-300}, {0.0, 1e300}, {1.0, 1e-15}});
    for (double& knot : knots) knot = offset + scale * knot;
    return knots;
  });
}

std::optional<Curve> any_curve(int dim) {
  const int degree = *rc::gen::inRange(1, 6);
  const int interior = *rc::gen::inRange(0, 5);
  const std::vector<double> knots = *knots_for(degree, interior);
  const auto n = static_cast<std::size_t>(degree + 1 + interior);
  Points points(dim, n);
  for (double& x : points.data()) x = *coordinate();
  if (*rc::gen::inRange(0, 3) == 0) std::copy(points[0].begin(), points[0].end(), points[n - 1].begin());
  std::vector<double> weights;
  if (*rc::gen::arbitrary<bool>()) {
    weights.resize(n);
    for (double& w : weights) w = *rc::gen::element(1.0, 1.0, 0.1, 10.0, 1e-100, 1e100, 1e-8);
  }
  try {
    return Curve(degree, knots, points, weights);
  } catch (const InvalidArgument&) {
    return std::nullopt;
  }
}

bool finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

// In the box of the control points, up to rounding: of the largest coordinate, or of the smallest normal
// number.
void check_point(const Curve& curve, const Point& point) {
  RC_ASSERT(finite(point));
  double slack = std::numeric_limits<double>::min();
  for (const double x : curve.control_points().data()) slack = std::max(slack, 1e-14 * std::abs(x));
  for (std::size_t c = 0; c < point.size(); ++c) {
    double lo = kInf;
    double hi = -kInf;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      lo = std::min(lo, curve.control_points()[i][c]);
      hi = std::max(hi, curve.control_points()[i][c]);
    }
    RC_ASSERT(lo - slack <= point[c] && point[c] <= hi + slack);
  }
}

// The action may refuse; nothing else may escape.
void attempt(const std::function<void()>& act) {
  try {
    act();
  } catch (const InvalidArgument& error) {
    RC_ASSERT(std::string(error.what()).size() > 10);
  }
}

double somewhere(const Curve& curve) {
  const Interval domain = curve.domain();
  const double share = *rc::gen::element(0.0, 1.0, 0.5, 0.3, 1e-16, 0.5 + 1e-12, -0.5, 1.5);
  return domain.lo + share * domain.length();
}

TEST(Nasty, CurvesEvaluateOrAreRefused) {
  EXPECT_TRUE(rc::check([] {
    const auto curve = any_curve(*rc::gen::inRange(1, 4));
    if (!curve) return;
    for (const double t : {somewhere(*curve), -kInf, kInf, curve->domain().lo, curve->domain().hi}) {
      check_point(*curve, curve->evaluate(t));
      for (const Side side : {Side::left, Side::right}) {
        const Points rows = curve->derivatives(t, 4, side);
        RC_ASSERT(finite(rows.data()));
      }
    }
    RC_ASSERT(std::isfinite(curve->extent()));
  }));
}

TEST(Nasty, EditingWorksOrRefuses) {
  EXPECT_TRUE(rc::check([] {
    const auto given = any_curve(2);
    if (!given) return;
    const Curve& curve = *given;
    const double t = somewhere(curve);
    const double u = somewhere(curve);
    const auto check = [&](const Curve& result) { check_point(curve, result.evaluate(result.domain().lo)); };
    attempt([&] { check(insert_knot(curve, t, *rc::gen::inRange(0, 4))); });
    attempt([&] { check(elevate_degree(curve, *rc::gen::inRange(0, 3))); });
    attempt([&] { check(split(curve, t).right); });
    attempt([&] { check(subcurve(curve, {t, u})); });
    attempt([&] { check(clamp(curve)); });
    attempt([&] { check(reverse(curve)); });
    attempt([&] { check(with_domain(curve, {t, u})); });
    attempt([&] {
      check(with_domain(curve, *rc::gen::element(Interval{0, 1}, Interval{1e6, 1e6 + 1}, Interval{0, 1e-300},
                                                 Interval{-1e304, 1e304}, Interval{1, 1 + kEps})));
    });
    attempt([&] {
      check(move_seam(curve, *rc::gen::element(t, u + 100 * curve.domain().length(), 1e300, kNan, -3.0)));
    });
    // A removal may leave the hull, by its tolerance.
    attempt([&] { RC_ASSERT(finite(remove_knot(curve, t, 2, curve.extent()).curve.evaluate(u))); });
    attempt([&] { (void)derivative_curve(curve); });
    attempt([&] { check(join(bezier_segments(curve))); });
  }));
}

TEST(Nasty, MeasuresAreFiniteAndBracketed) {
  EXPECT_TRUE(rc::check([] {
    const auto curve = any_curve(2);
    if (!curve) return;
    const Box box = bounding_box(*curve);
    RC_ASSERT(finite(box.lo) && finite(box.hi));
    RC_ASSERT(std::isfinite(box.diagonal()));
    check_point(*curve, box.lo);
    check_point(*curve, box.hi);
    const ArcLength length(*curve, *rc::gen::element(1e-3, 1e-10, 1e-300));
    RC_ASSERT(std::isfinite(length.length()) && length.length() >= 0.0);
    // Weights 1e100 apart hide the whole length in a span of parameters that no quadrature finds.
    const auto& w = curve->weights();
    const bool sane =
        w.empty() || *std::max_element(w.begin(), w.end()) <= 1e9 * *std::min_element(w.begin(), w.end());
    double before = curve->domain().lo;
    for (const double share : {-1.0, 0.0, 0.2, 0.7, 1.0, 2.0}) {
      const double t = length.parameter_at(share * length.length());
      RC_ASSERT(curve->domain().contains(t) && (t >= before || !sane));
      before = t;
      const double s = length.length_to(t);
      RC_ASSERT(0.0 <= s && s <= length.length());
    }
    RC_ASSERT(curve->domain().contains(length.parameter_at(kNan)));
  }));
}

TEST(Nasty, CompositionWorksOrRefuses) {
  EXPECT_TRUE(rc::check([] {
    const auto outer = any_curve(2);
    const auto inner = any_curve(1);
    if (!outer || !inner) return;
    attempt([&] { (void)compose(*outer, *inner); });
    // The same function, made to fit: increasing control points from one end of the domain to the other.
    Points rising(1, inner->size());
    std::vector<double> steps;
    for (std::size_t i = 1; i < inner->size(); ++i)
      steps.push_back(*rc::gen::element(0.0, 1.0, 1e-9, 1e-13, 5.0));
    double sum = 0.0;
    for (const double step : steps) sum += step;
    double at = 0.0;
    for (std::size_t i = 0; i < inner->size(); ++i) {
      rising[i][0] = outer->domain().lo + (sum > 0.0 ? at / sum : 0.0) * outer->domain().length();
      if (i < steps.size()) at += steps[i];
    }
    attempt([&] {
      const Curve function = clamp(Curve(inner->degree(), inner->knots(), rising, inner->weights()));
      const Curve composed = compose(*outer, function);
      RC_ASSERT(composed.domain() == function.domain());
      for (const double share : {0.0, 0.2, 0.5, 1.0}) {
        const double u = composed.domain().lo + share * composed.domain().length();
        RC_ASSERT(finite(composed.evaluate(u)));
      }
    });
  }));
}

TEST(Nasty, CompatibilityWorksOrRefuses) {
  EXPECT_TRUE(rc::check([] {
    std::vector<Curve> curves;
    for (int i = 0; i < 3; ++i) {
      if (const auto curve = any_curve(2)) curves.push_back(*curve);
    }
    attempt([&] {
      for (const Curve& curve : make_compatible(curves)) RC_ASSERT(curve.domain() == curves[0].domain());
    });
    attempt([&] {
      for (const Curve& curve : with_common_denominator(curves))
        RC_ASSERT(curve.domain() == curves[0].domain());
    });
  }));
}

}  // namespace
}  // namespace tandem
