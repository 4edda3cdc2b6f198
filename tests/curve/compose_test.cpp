#include "tandem/curve/compose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "curve/random_curves.h"
#include "curve/reference.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using testing::norm;
using testing::probes;
using testing::RandomCurves;
using testing::reference_point;

// A strictly increasing scalar spline from `from.lo` to `from.hi`: increasing control points.
Curve increasing(RandomCurves& random, int degree, int spans, bool rational, bool clamped, Interval values,
                 Interval domain) {
  const Curve any = random.curve(degree, 1, spans, rational, clamped, domain.lo, domain.hi);
  Points points(1, any.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < any.size(); ++i) {
    points[i][0] = sum;
    sum += std::pow(10.0, random.uniform(-2.0, 0.0));
  }
  const Curve rising(degree, any.knots(), points, any.weights());
  const double a = rising.evaluate(domain.lo)[0];
  const double b = rising.evaluate(domain.hi)[0];
  for (double& x : points.data()) x = values.lo + (x - a) / (b - a) * values.length();
  return Curve(degree, any.knots(), points, any.weights());
}

// Largest |composed(u) - outer(inner(u))| in sizes of outer, beyond what a parameter rounded by one ulp is
// worth.
double gap(const Curve& composed, const Curve& outer, const Curve& inner) {
  const double ulp = std::numeric_limits<double>::epsilon() *
                     std::max(std::abs(inner.domain().lo), std::abs(inner.domain().hi));
  double largest = 0.0;
  for (const double u : probes(composed, 41)) {
    const auto expected = reference_point(outer, reference_point(inner, u)[0]);
    const auto found = reference_point(composed, u);
    double sum = 0.0;
    for (std::size_t c = 0; c < expected.size(); ++c) {
      sum += static_cast<double>((expected[c] - found[c]) * (expected[c] - found[c]));
    }
    double speed = 0.0;
    for (const Side side : {Side::left, Side::right}) {
      const Points d = composed.derivatives(u, 1, side);
      speed = std::max(speed, norm(d[1]));
    }
    largest = std::max(largest, std::sqrt(sum) - ulp * speed);
  }
  return largest / outer.extent();
}

TEST(Compose, AgreesWithOuterAfterInner) {
  RandomCurves random(30);
  for (int p = 1; p <= 5; ++p) {
    for (int q = 1; q <= 4; ++q) {
      for (int i = 0; i < 200; ++i) {
        const Curve outer = random.curve(p, 2, random.integer(1, 5), i % 2 == 0, i % 3 != 0, -1.0, 2.5);
        const Curve inner =
            increasing(random, q, random.integer(1, 5), i % 4 < 2, i % 5 != 0, {-1.0, 2.5}, {0.0, 1.0});
        const Curve composed = compose(outer, inner);
        ASSERT_EQ(composed.degree(), p * q);
        ASSERT_EQ(composed.domain(), inner.domain());
        ASSERT_LE(gap(composed, outer, inner), 1e-12) << p << " o " << q << ", case " << i;
      }
    }
  }
}

TEST(Compose, LineAfterParabola) {
  const Curve line = Curve::bezier(Points({{0, 0}, {2, 4}}));
  const Curve square = Curve::bezier(Points(1, std::vector<double>{0, 0, 1}));  // u^2
  EXPECT_EQ(compose(line, square).control_points(), Points({{0, 0}, {0, 0}, {2, 4}}));
  EXPECT_EQ(compose(line, square).degree(), 2);
}

TEST(Compose, ParabolaAfterParabola) {
  const Curve parabola = Curve::bezier(Points({{0, 0}, {0.5, 0}, {1, 1}}));  // (t, t^2)
  const Curve square = Curve::bezier(Points(1, std::vector<double>{0, 0, 1}));
  // (u^2, u^4)
  const Curve expected = Curve::bezier(Points({{0, 0}, {0, 0}, {1.0 / 6, 0}, {0.5, 0}, {1, 1}}));
  const Curve composed = compose(parabola, square);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_NEAR(composed.control_points().data()[i], expected.control_points().data()[i], 1e-16);
  }
}

TEST(Compose, ReparametrisedQuarterCircleStaysRound) {
  const double h = std::sqrt(0.5);
  const Curve arc = Curve::bezier(Points({{1, 0}, {1, 1}, {0, 1}}), {1, h, 1});
  const Curve v = Curve::bezier(Points(1, std::vector<double>{0, 0.1, 0.7, 1}), {1, 3, 0.5, 2});
  const Curve composed = compose(arc, v);
  EXPECT_EQ(composed.degree(), 6);
  for (int i = 0; i <= 50; ++i) {
    const Point p = composed.evaluate(i / 50.0);
    EXPECT_NEAR(std::hypot(p[0], p[1]), 1.0, 1e-15);
  }
}

TEST(Compose, KnotsAreThoseOfBothWithTheContinuityOfBoth) {
  RandomCurves random(31);
  // Cubic, C2 at 1, C1 at 2, a corner at 3; inner piecewise linear with breaks at u = 10 (v = 0.5) and 20 (v
  // = 2).
  const std::vector<double> knots{0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 4, 4, 4, 4};
  const Curve outer(3, knots, random.points(2, 10));
  const Curve linear(1, {0, 0, 10, 20, 30, 30}, Points(1, std::vector<double>{0, 0.5, 2, 4}));
  const std::vector<Knot> expected{{0, 4}, {10, 3}, {10 + 10.0 / 3, 1}, {20, 3}, {25, 3}, {30, 4}};
  const auto found = distinct_knots(compose(outer, linear).knots());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].value, expected[i].value, 1e-14);
    EXPECT_EQ(found[i].multiplicity, expected[i].multiplicity);
  }
  // A smooth quadratic: C1 at its knot, where the outer curve has none; C2, C1, C0 at the outer knots'
  // images.
  const Curve quadratic(2, {0, 0, 0, 5, 10, 10, 10}, Points(1, std::vector<double>{0, 0.7, 2.6, 4}));
  const auto smooth = distinct_knots(compose(outer, quadratic).knots());
  ASSERT_EQ(smooth.size(), 6U);
  for (const Knot& knot : smooth) {
    if (knot.value == 0.0 || knot.value == 10.0) continue;
    const double v = quadratic.evaluate(knot.value)[0];
    const int continuity = knot.value == 5.0 ? 1 : 3 - multiplicity(knots, std::round(v));
    EXPECT_EQ(knot.multiplicity, 6 - continuity) << v;
  }
}

TEST(Compose, CornersThatCoincideStayWhereTheyAre) {
  const Curve square(1, {0, 0, 1, 2, 3, 4, 4}, Points({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}));
  // Values within rounding of the corners.
  const Curve v(1, {0, 0, 0.3, 0.35, 0.8, 1, 1},
                Points(1, std::vector<double>{0, 1 + 1e-13, 2 - 1e-13, 3, 4 + 1e-13}));
  const Curve composed = compose(square, v);
  EXPECT_EQ(composed.knots(), v.knots());
  EXPECT_EQ(composed.control_points(), square.control_points());
}

TEST(Compose, FarOffDomains) {
  RandomCurves random(33);
  for (int i = 0; i < 200; ++i) {
    const Interval values{1e6, 1e6 + 1};
    const Curve outer = with_domain(
        random.curve(random.integer(1, 4), 2, random.integer(1, 5), i % 2 == 0, i % 3 != 0), values);
    const Curve inner = increasing(random, random.integer(1, 3), random.integer(1, 5), i % 4 < 2, i % 5 != 0,
                                   values, {-1e6, -1e6 + 1});
    const Curve composed = compose(outer, inner);
    // Values and parameters near 1e6 are good to 1e-10; inner slopes reach 100 where spans are short.
    for (const double u : probes(composed)) {
      double speed = norm(composed.derivatives(u, 1)[1]);
      const double v = inner.evaluate(u)[0];
      for (const Side side : {Side::left, Side::right})
        speed = std::max(speed, norm(outer.derivatives(v, 1, side)[1]));
      EXPECT_LE(testing::distance(composed.evaluate(u), outer.evaluate(v)), 1e-12 + 1e-8 * speed);
    }
  }
}

TEST(Compose, HugeAndTinyCurves) {
  RandomCurves random(34);
  for (const double size : {1e300, 1e-300}) {
    for (int i = 0; i < 50; ++i) {
      const int p = random.integer(1, 5);
      const int q = random.integer(1, 4);
      const Curve usual = random.curve(p, 2, 3, i % 2 == 0, true);
      Points points = usual.control_points();
      for (double& x : points.data()) x *= size;
      const Curve outer(p, usual.knots(), points, usual.weights());
      const Curve inner = increasing(random, q, 3, i % 4 < 2, true, {0, 1}, {0, 1});
      const Curve composed = compose(outer, inner);
      const Curve expected = compose(usual, inner);
      for (const double u : probes(composed, 11)) {
        const Point a = composed.evaluate(u);
        const Point b = expected.evaluate(u);
        EXPECT_NEAR(a[0] / size, b[0], 1e-12);
        EXPECT_NEAR(a[1] / size, b[1], 1e-12);
      }
    }
  }
}

// Breaks of the inner function at knots of the outer one, but for rounding: no knot may be doubled, and
// corners must be met exactly.
TEST(Compose, CoincidentBreaksNeverDouble) {
  RandomCurves random(35);
  for (int i = 0; i < 300; ++i) {
    const int p = random.integer(1, 4);
    const Curve outer = random.curve(p, 2, random.integer(2, 6), i % 2 == 0, true, -2.0, 5.0);
    const std::vector<Knot> knots = distinct_knots(outer.knots());
    const int q = random.integer(1, 3);
    // A C0 inner function of degree q through all the outer knots.
    std::vector<double> u(static_cast<std::size_t>(q) + 1, 0.0);
    Points values(1, 0);
    values.push_back(std::vector<double>{-2.0});
    for (std::size_t k = 1; k < knots.size(); ++k) {
      const bool last = k + 1 == knots.size();
      u.insert(u.end(), static_cast<std::size_t>(last ? q + 1 : q), static_cast<double>(k));
      const double error = random.uniform(-1e-13, 1e-13);
      for (int j = 1; j <= q; ++j) {
        const double share = static_cast<double>(j) / q;
        values.push_back(
            std::vector<double>{(1 - share) * knots[k - 1].value + share * knots[k].value + error});
      }
    }
    const Curve inner(q, u, values);
    const Curve composed = compose(outer, inner);
    const std::vector<Knot> found = distinct_knots(composed.knots());
    ASSERT_EQ(found.size(), knots.size());
    for (std::size_t k = 0; k < knots.size(); ++k) {
      EXPECT_EQ(found[k].value, static_cast<double>(k));
      const Point expected = outer.evaluate(knots[k].value);
      const Point at = composed.evaluate(static_cast<double>(k));
      // Exact but for the division by the weight.
      EXPECT_NEAR(at[0], expected[0], 4e-16);
      EXPECT_NEAR(at[1], expected[1], 4e-16);
    }
  }
}

TEST(Compose, StandstillsOfTheInnerFunction) {
  // u^3 around its standstill at 0, whose value is a knot of the outer curve, and one beside it.
  const Curve cube = Curve::bezier(Points(1, std::vector<double>{-1, 1, -1, 1}), {}, {-1, 1});
  for (const double at : {0.0, 1e-9, 0.3}) {
    const Curve outer(2, {-1, -1, -1, at, at, 1, 1, 1}, Points({{-1, 1}, {-1, 0}, {0, 0}, {0, 1}, {1, 1}}));
    const Curve composed = compose(outer, cube);
    ASSERT_EQ(distinct_knots(composed.knots()).size(), 3U);
    // Values are rounded to 1e-16; the slope 3 u^2 of the inner function says what that is in u.
    const double u = std::cbrt(at);
    EXPECT_NEAR(distinct_knots(composed.knots())[1].value, u, u > 0.0 ? 1e-15 + 2e-16 / (3 * u * u) : 0.0);
    EXPECT_LE(gap(composed, outer, cube), 1e-12);
  }
}

TEST(Compose, IdentityGivesTheCurveBack) {
  RandomCurves random(32);
  const Curve outer = random.curve(3, 2, 6, false, true);
  const Curve identity = Curve::bezier(Points({{0.0}, {1.0}}));
  EXPECT_EQ(compose(outer, identity), outer);
}

TEST(Compose, RefusesWhatIsNotAReparametrisation) {
  const Curve outer = Curve::bezier(Points({{0, 0}, {1, 2}, {3, 0}}));
  const auto scalar = [](std::vector<double> values) { return Curve::bezier(Points(1, std::move(values))); };
  EXPECT_THROW((void)compose(outer, outer), InvalidArgument);
  EXPECT_THROW((void)compose(outer, scalar({1, 0})), InvalidArgument);
  EXPECT_THROW((void)compose(outer, scalar({0.5, 0.5})), InvalidArgument);
  EXPECT_THROW((void)compose(outer, scalar({0, 1.1})), InvalidArgument);
  EXPECT_THROW((void)compose(outer, scalar({-0.1, 1})), InvalidArgument);
  EXPECT_THROW((void)compose(outer, scalar({0, 2, -1, 1})), InvalidArgument);  // turns back in the middle
  EXPECT_NO_THROW((void)compose(outer, scalar({0, 0.5, 0.4, 1})));  // its polygon does, the function does not
}

}  // namespace
}  // namespace tandem
