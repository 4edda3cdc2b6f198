#include "tandem/curve/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "curve/random_curves.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using testing::distance;
using testing::RandomCurves;

std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "no error";
}

TEST(Curve, QuarterCircleIsRoundAndTurnsAsItShould) {
  const double h = std::sqrt(0.5);
  const Curve arc = Curve::bezier(Points({{1, 0}, {1, 1}, {0, 1}}), {1, h, 1});
  for (int i = 0; i <= 50; ++i) {
    const double t = i / 50.0;
    const Points d = arc.derivatives(t, 2);
    const double x = d[0][0], y = d[0][1];
    EXPECT_NEAR(x * x + y * y, 1.0, 4e-16);
    EXPECT_NEAR(x * d[1][0] + y * d[1][1], 0.0, 1e-15);
    // On a unit circle the curvature is 1: det(C', C'') = |C'|^3.
    const double speed2 = d[1][0] * d[1][0] + d[1][1] * d[1][1];
    EXPECT_NEAR(d[1][0] * d[2][1] - d[1][1] * d[2][0], speed2 * std::sqrt(speed2), 1e-13);
  }
}

TEST(Curve, DerivativesOfAPowerAreKnown) {
  // t^4 over [0, 1] in Bernstein form: only the last coefficient is not zero.
  const Curve power = Curve::bezier(Points(1, std::vector<double>{0, 0, 0, 0, 1}));
  const double t = 0.7;
  const Points d = power.derivatives(t, 6);
  const double expected[] = {std::pow(t, 4), 4 * std::pow(t, 3), 12 * t * t, 24 * t, 24, 0, 0};
  for (std::size_t r = 0; r < 7; ++r) EXPECT_NEAR(d[r][0], expected[r], 1e-13) << r;
}

TEST(Curve, DerivativesAgreeWithFiniteDifferences) {
  RandomCurves random(20);
  for (int i = 0; i < 100; ++i) {
    const Curve curve = random.curve(random.integer(1, 5), 2, random.integer(1, 3), i % 2 == 0, i % 3 == 0);
    const double t = random.uniform(0.05, 0.95);
    const double h = 1e-6;
    bool knot_near = false;
    for (const double knot : curve.knots()) knot_near = knot_near || std::abs(knot - t) < 2 * h;
    if (knot_near) continue;
    const Points at = curve.derivatives(t, 4);
    const Points before = curve.derivatives(t - h, 3);
    const Points after = curve.derivatives(t + h, 3);
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t c = 0; c < 2; ++c) {
        const double scale = 1.0 + std::abs(at[r + 1][c]) + std::abs(at[r][c]) +
                             (r < 3 ? std::abs(at[r + 1][c]) : 0.0) + std::abs(before[r][c]);
        EXPECT_NEAR((after[r][c] - before[r][c]) / (2 * h), at[r + 1][c], 2e-4 * scale * 10);
      }
    }
  }
}

TEST(Curve, SidesDifferAtACorner) {
  const Curve corner(1, {0, 0, 1, 2, 2}, Points({{0, 0}, {1, 0}, {1, 3}}));
  EXPECT_EQ(corner.derivatives(1.0, 1, Side::left), Points({{1, 0}, {1, 0}}));
  EXPECT_EQ(corner.derivatives(1.0, 1, Side::right), Points({{1, 0}, {0, 3}}));
  EXPECT_EQ(corner.derivatives(0.0, 1, Side::left), corner.derivatives(0.0, 1, Side::right));
  EXPECT_EQ(corner.derivatives(2.0, 1, Side::left), corner.derivatives(2.0, 1, Side::right));
  EXPECT_EQ(corner.evaluate(-7.0), (Point{0, 0}));
  EXPECT_EQ(corner.evaluate(7.0), (Point{1, 3}));
}

TEST(Curve, EndsAreExact) {
  RandomCurves random(21);
  for (int i = 0; i < 100; ++i) {
    const Curve curve = random.curve(random.integer(1, 5), 3, random.integer(1, 4), false, true, 0.1, 0.7);
    const Point start(curve.control_points().front().begin(), curve.control_points().front().end());
    const Point end(curve.control_points().back().begin(), curve.control_points().back().end());
    EXPECT_EQ(curve.evaluate(0.1), start);
    EXPECT_EQ(curve.evaluate(0.7), end);
  }
}

TEST(Curve, HighDegreeStaysInItsHull) {
  RandomCurves random(22);
  const Curve curve = Curve::bezier(random.points(2, 61), random.weights(61));
  for (int i = 0; i <= 100; ++i) {
    const Point p = curve.evaluate(i / 100.0);
    EXPECT_LE(std::abs(p[0]), 1.0);
    EXPECT_LE(std::abs(p[1]), 1.0);
  }
}

TEST(Curve, ClosedAndPeriodicAreFacts) {
  const Curve square(1, {0, 0, 1, 2, 3, 4, 4}, Points({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}));
  EXPECT_TRUE(square.is_closed());
  EXPECT_FALSE(square.is_periodic());
  const Curve open = Curve::bezier(Points({{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_FALSE(open.is_closed());
  const Curve point = Curve::bezier(Points({{2, 3}, {2, 3}}));
  EXPECT_FALSE(point.is_closed());
  EXPECT_EQ(point.extent(), 0.0);
  const Curve loop(2, {0, 1, 2, 3, 4, 5, 6, 7, 8}, Points({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {2, 0}}));
  EXPECT_TRUE(loop.is_closed());
  EXPECT_TRUE(loop.is_periodic());
}

TEST(Curve, ExtentNeitherOverflowsNorVanishes) {
  EXPECT_DOUBLE_EQ(Curve::bezier(Points({{0, 0}, {3e300, 4e300}})).extent(), 5e300);
  EXPECT_DOUBLE_EQ(Curve::bezier(Points({{0, 0}, {3e-300, 4e-300}})).extent(), 5e-300);
  EXPECT_TRUE(Curve::bezier(Points({{0, 0}, {3e-300, 4e-300}, {0, 0}})).is_closed());
  EXPECT_TRUE(Curve::bezier(Points({{1e300, 0}, {-3e300, 4e300}, {1e300, 0}})).is_closed());
}

TEST(Curve, HugeAndTinyCurvesEvaluate) {
  for (const double size : {1e300, 1e-300}) {
    const Curve curve = Curve::bezier(Points({{0, 0}, {size, size}, {2 * size, 0}}), {1, 2, 1});
    const Points d = curve.derivatives(0.5, 3);
    EXPECT_NEAR(d[0][0] / size, 1.0, 1e-14);
    EXPECT_NEAR(d[0][1] / size, 2.0 / 3.0, 1e-14);
    for (const double x : d.data()) EXPECT_TRUE(std::isfinite(x));
  }
  // A speed beyond the range of double is cut off, not infinite and not NaN.
  const Curve fast = Curve::bezier(Points({{0, 0}, {1e300, 1e300}}), {}, {0, 1e-300});
  const Points speeds = fast.derivatives(0.0, 2);
  for (const double x : speeds.data()) EXPECT_TRUE(std::isfinite(x));
}

TEST(Curve, RefusesBrokenInputAndSaysWhere) {
  const double inf = std::numeric_limits<double>::infinity();
  const Points three({{0, 0}, {1, 1}, {2, 0}});
  const auto make = [&](int degree, std::vector<double> knots, std::vector<double> weights = {}) {
    return message_of([&] { Curve(degree, std::move(knots), three, std::move(weights)); });
  };
  EXPECT_EQ(make(2, {0, 0, 0, 0.5, 0.4, 1}), "knot 4 is 0.4, before knot 3 (0.5)");
  EXPECT_EQ(make(2, {0, 0, 0, 1}), "4 knots do not fit 3 control points of degree 2, expected 6 (3 + 2 + 1)");
  EXPECT_EQ(make(2, {1, 1, 1, 1, 1, 1}), "the domain [1, 1] (knots 2 and 3) is empty");
  EXPECT_EQ(make(0, {0, 1, 2, 3}), "the degree is 0, expected at least 1");
  EXPECT_EQ(make(3, {0, 0, 0, 0, 1, 1, 1}), "3 control points are too few for degree 3, expected at least 4");
  EXPECT_EQ(make(2, {0, 0, NAN, 1, 1, 1}), "knot 2 is nan, expected a finite number");
  EXPECT_EQ(make(2, {0, 0, 0, inf, inf, inf}), "knot 3 is inf, expected a finite number");
  EXPECT_EQ(make(2, {0, 0, 0, 1, 1, 1}, {1, 0, 1}), "weight 1 is 0, expected a positive number");
  EXPECT_EQ(make(2, {0, 0, 0, 1, 1, 1}, {1, -2, 1}), "weight 1 is -2, expected a positive number");
  EXPECT_EQ(make(2, {0, 0, 0, 1, 1, 1}, {1, NAN, 1}), "weight 1 is nan, expected a positive number");
  EXPECT_NE(make(2, {0, 0, 0, 1, 1, 1}, {1, inf, 1}), "no error");
  EXPECT_EQ(make(2, {0, 0, 0, 1, 1, 1}, {1, 1}), "2 weights for 3 control points, expected one each");
  EXPECT_EQ(message_of([] {
              Curve(1, {0, 0, 1, 1, 2, 2}, Points({{0}, {1}, {2}, {3}}));
            }),
            "knot 2 (1) has a multiplicity above 1, the degree: the curve would break there");
  EXPECT_EQ(message_of([] {
              Curve(1, {0, 0, 0, 1, 1}, Points({{0}, {1}, {2}}));
            }),
            "knot 0 (0) has a multiplicity above 2, the degree plus one");
  EXPECT_EQ(message_of([] {
              (void)Curve::bezier(Points({{0, 0}, {NAN, 1}}));
            }),
            "coordinate 0 of control point 1 is nan, expected a finite number");
  EXPECT_NE(message_of([] { (void)Curve::bezier(Points({{-1.7e308}, {1.7e308}})); }), "no error");
  EXPECT_NE(message_of([] { (void)Curve::bezier(Points()); }), "no error");
  EXPECT_NE(message_of([] { (void)Curve::bezier(Points({{1, 2}})); }), "no error");
  const Curve line = Curve::bezier(Points({{0.0}, {1.0}}));
  EXPECT_THROW((void)line.evaluate(NAN), InvalidArgument);
  EXPECT_THROW((void)line.derivatives(0.5, -1), InvalidArgument);
}

TEST(Points, ChecksShapes) {
  EXPECT_THROW(Points(0, std::size_t{3}), InvalidArgument);
  EXPECT_THROW(Points(2, std::vector<double>{1, 2, 3}), InvalidArgument);
  EXPECT_THROW(Points({{1, 2}, {3}}), InvalidArgument);
  Points points({{1, 2}});
  for (int i = 0; i < 10; ++i) points.push_back(points[0]);  // of itself
  EXPECT_EQ(points.size(), 11U);
  EXPECT_EQ(points[10][1], 2.0);
  EXPECT_THROW(points.push_back(std::vector<double>{1}), InvalidArgument);
  EXPECT_EQ(Points().dim(), 0);
  EXPECT_EQ(Points().size(), 0U);
}

TEST(Knots, UniformDistinctAndSpans) {
  EXPECT_EQ(clamped_uniform_knots(2, 4), (std::vector<double>{0, 0, 0, 0.5, 1, 1, 1}));
  EXPECT_THROW((void)clamped_uniform_knots(3, 3), InvalidArgument);
  EXPECT_THROW((void)clamped_uniform_knots(-1, 3), InvalidArgument);
  const std::vector<double> knots{0, 0, 0, 1, 1, 2, 2, 2};
  EXPECT_EQ(distinct_knots(knots), (std::vector<Knot>{{0, 3}, {1, 2}, {2, 3}}));
  EXPECT_EQ(multiplicity(knots, 1.0), 2);
  EXPECT_EQ(multiplicity(knots, 1.5), 0);
  EXPECT_EQ(find_span(knots, 2, -1.0), 2U);
  EXPECT_EQ(find_span(knots, 2, 0.5), 2U);
  EXPECT_EQ(find_span(knots, 2, 1.0), 4U);
  EXPECT_EQ(find_span(knots, 2, 2.0), 4U);
  EXPECT_EQ(find_span(knots, 2, 9.0), 4U);
}

}  // namespace
}  // namespace tandem
