#include "tandem/io/itd.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/paths.h"
#include "tandem/error.h"

namespace {

using tandem::Curve;
using tandem::format_itd;
using tandem::parse_itd;
using tandem::Points;
using tandem::test::BadInput;

TEST(Itd, ReadsBsplinesAndBeziers) {
  const auto curves = parse_itd(R"(
A header that nobody "reads, and which has no end of its string
[OBJECT ALL
    [OBJECT [COLOR 4] [RGB "1,2,]3"] FIRST
        [CURVE BSPLINE 4 3 E2
            [KV 0 0 0 .5 1. 1e0 +1]
            [0 0]
            [1 -2.5]
            [3 2]
            [4 0]
        ]
    ]
    ; a comment ] with a bracket
    [OBJECT SECOND [CURVE BEZIER [WIDTH 0.1] 3 E3 [0 0 0][1 2 3][4 5 6]]]
]
)");
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0], Curve(2, {0, 0, 0, 0.5, 1, 1, 1}, Points({{0, 0}, {1, -2.5}, {3, 2}, {4, 0}})));
  EXPECT_EQ(curves[1], Curve::bezier(Points({{0, 0, 0}, {1, 2, 3}, {4, 5, 6}})));
}

TEST(Itd, DividesRationalPointsByTheirWeights) {
  const auto curves = parse_itd("[CURVE BEZIER 3 P2 [1 1 0] [0.5 0.5 0.5] [2 0 2]]");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0], Curve::bezier(Points({{1, 0}, {1, 1}, {0, 1}}), {1, 0.5, 2}));
}

TEST(Itd, UnrollsPeriodicCurves) {
  // 4 points, order 3: 4 + 3 + 2 knots, and the first 2 points come again.
  const auto curves =
      parse_itd("[OBJECT P [CURVE BSPLINE 4 3 E2 [KVP 0 1 2 3 4 5 6 7 8] [1 0] [0 1] [-1 0] [0 -1]]]");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0].size(), 6U);
  EXPECT_TRUE(curves[0].is_periodic());
  EXPECT_EQ(curves[0].domain(), (tandem::Interval{2, 6}));
}

TEST(Itd, PassesOverOtherObjects) {
  const auto curves = parse_itd(R"([OBJECT A
    [MATRIX 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1]
    [POLYGON [PLANE 0 0 1 0] 3 [[NORMAL 0 0 1] 0 0 0] [1 0 0] [0 1 0]]
    [TRIMSRF [SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [1 1 0]]
      [LOOP [TRIMCRV [TRIMCRVSEG [CURVE BEZIER 2 E2 [0 0] [1 1]]]]]]
    [STRING "[CURVE BEZIER 2 E1 [0] [1]]"]
    [NUMBER 3]
  ] [OBJECT [CurveStroke [OBJECT DAVID [CURVE BEZIER 2 E1 [7] [8]]]] WGLASS [SURFACE BEZIER 1 1 E1 [0]]])");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0], Curve::bezier(Points({{7}, {8}})));
}

TEST(Itd, StandsAnyDepthOfLists) {
  const std::string open(100000, '[');
  const std::string close(100000, ']');
  EXPECT_EQ(parse_itd(open + "CURVE BEZIER 2 E1 [7] [8]" + close).size(), 1U);
  EXPECT_EQ(parse_itd("[CURVE BEZIER " + open + close + " 2 E1 [7] [8]]").size(), 1U);
}

const BadInput kBad[] = {
    {"", 1, 1, "there is no [CURVE ...] in it"},
    {"no brackets", 1, 1, "there is no [CURVE ...] in it"},
    {"[OBJECT A [NUMBER 3]]", 1, 1, "there is no [CURVE ...] in it"},
    {"x\n [OBJECT A [NUMBER 3]", 2, 2, "this '[' is never closed"},
    {"[OBJECT A [CURVE", 1, 1, "this '[' is never closed"},
    {"[OBJECT [RGB \"1,2\n]]", 1, 14, "this string is not closed on its line"},
    {"[CURVE]", 1, 7, "expected BEZIER or BSPLINE, found ']'"},
    {"[CURVE POWER 3 E2 [0 0]]", 1, 8, "expected BEZIER or BSPLINE, found 'POWER'"},
    {"[CURVE BEZIER E2]", 1, 15, "expected the number of points, found 'E2'"},
    {"[CURVE BEZIER -3 E2]", 1, 15, "expected the number of points, found '-3'"},
    {"[CURVE BEZIER 99999999999 E2]", 1, 15, "expected the number of points"},
    {"[CURVE BSPLINE 3 E2]", 1, 18, "expected the order, found 'E2'"},
    {"[CURVE BEZIER 3 E0 [0]]", 1, 17, "expected a point type, E1 to E9 or P1 to P9, found 'E0'"},
    {"[CURVE BEZIER 3 Q2 [0]]", 1, 17, "expected a point type"},
    {"[CURVE BEZIER 1 E1 [0]]", 1, 1, "order 1 is a set of points; expected 2 or more"},
    {"[CURVE BSPLINE 3 1 E1 [KV 0 1 2 3] [0][1][2]]", 1, 1, "order 1 is a set of points"},
    {"[CURVE BSPLINE 2 3 E1 [KV 0 0 0 1 1] [0][1]]", 1, 1, "2 points are too few for order 3"},
    {"[CURVE BEZIER 999999999 E1 [0]]", 1, 1, "order 999999999 is beyond the largest"},
    {"[CURVE BSPLINE 999999999 3 E1 [KV 0 0 0 1 1]]", 1, 32, "5 knots, expected 1000000002"},
    {"[CURVE BSPLINE 3 3 E1 [0]]", 1, 24, "expected KV or KVP, found '0'"},
    {"[CURVE BSPLINE 3 3 E1 [KV 0 0 0 1 1] [0][1][2]]", 1, 24, "5 knots, expected 6 (3 points, order 3)"},
    {"[CURVE BSPLINE 3 3 E1 [KVP 0 0 0 1 1 1] [0][1][2]]", 1, 24,
     "6 knots, expected 8 (3 points, order 3, periodic)"},
    {"[CURVE BSPLINE 3 3 E1 [KV 0 0 x 1 1 1] [0][1][2]]", 1, 31, "expected a knot, found 'x'"},
    {"[CURVE BSPLINE 3 3 E1 [KV 0 0 1e301 1 1 1] [0][1][2]]", 1, 31, "the knot lies beyond 1e300"},
    {"[CURVE BSPLINE 3 3 E1 [KV 0 0 nan 1 1 1] [0][1][2]]", 1, 31, "expected a knot, found 'nan'"},
    {"[CURVE BSPLINE 3 3 E1 [KV 0 0 0 1 0.5 1] [0][1][2]]", 1, 1, "knot"},
    {"[CURVE BEZIER 2 E2 [0 0] [1]]", 1, 28, "expected a coordinate, found ']'"},
    {"[CURVE BEZIER 2 E2 [0 0] [1 2 3]]", 1, 31, "expected ']' after 2 numbers, found '3'"},
    {"[CURVE BEZIER 2 E2 [0 0]]", 1, 25, "expected '[' of a point, found ']'"},
    {"[CURVE BEZIER 2 E2 [0 0] [1 1] [2 2]]", 1, 32, "expected ']' after 2 points, found '['"},
    {"[CURVE BEZIER 2 P1 [1 0] [0 1]]", 1, 27, "the weight is 0, expected more than 0"},
    {"[CURVE BEZIER 2 P1 [1 0] [-1 1]]", 1, 27, "the weight is -1, expected more than 0"},
    {"[CURVE BEZIER 2 P1 [1 0] [1e-300 1e10]]", 1, 34, "lies beyond 1e300"},
    {"[CURVE BEZIER 2 E1 [0] [\"1\"]]", 1, 25, "expected a coordinate, found \"1\""},
    {"[CURVE BEZIER 2 E1 [0] [1e999]]", 1, 25, "expected a coordinate, found '1e999'"},
};

TEST(Itd, SaysWhatIsWrongAndWhere) {
  for (const BadInput& bad : kBad) {
    tandem::test::expect_refused(bad, [](const std::string& text) { (void)parse_itd(text); });
  }
}

Curve any_curve(bool rational) {
  const int degree = *rc::gen::inRange(1, 5);
  const int dim = *rc::gen::inRange(1, 10);
  const int n = degree + 1 + *rc::gen::inRange(0, 6);
  std::vector<double> coordinates;
  for (int i = 0; i < n * dim; ++i) {
    coordinates.push_back(
        std::ldexp(*rc::gen::inRange(-1000000, 1000000) / 777.0, *rc::gen::inRange(-40, 40)));
  }
  std::vector<double> weights;
  for (int i = 0; rational && i < n; ++i) weights.push_back(*rc::gen::inRange(1, 100000) / 777.0);
  std::vector<double> knots;
  for (int i = 0; i < n + degree + 1; ++i) {
    knots.push_back((knots.empty() ? -3.0 : knots.back()) + *rc::gen::inRange(1, 1000) / 777.0);
  }
  return Curve(degree, knots, Points(dim, coordinates), weights);
}

TEST(Itd, ReadsPolynomialCurvesBackEqual) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Curve> curves = {any_curve(false), any_curve(false)};
    RC_ASSERT(parse_itd(format_itd(curves)) == curves);
  }));
}

TEST(Itd, ReadsRationalCurvesBackWithinRounding) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Curve> curves = {any_curve(true)};
    const std::vector<Curve> again = parse_itd(format_itd(curves));
    RC_ASSERT(again[0].knots() == curves[0].knots());
    RC_ASSERT(again[0].weights() == curves[0].weights());
    const auto a = curves[0].control_points().data();
    const auto b = again[0].control_points().data();
    RC_ASSERT(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      // The format holds w x, rounded: one unit in the last place is what there is to lose.
      RC_ASSERT(std::fabs(a[i] - b[i]) <= std::fabs(std::nextafter(a[i], 2 * a[i]) - a[i]));
    }
    RC_ASSERT(parse_itd(format_itd(again)) == again);  // and it is lost once only
  }));
}

TEST(Itd, WritesNoMoreThanTheFormatHolds) {
  const std::vector<Curve> ten = {Curve::bezier(Points(10, 2))};
  EXPECT_THROW((void)format_itd(ten), tandem::InvalidArgument);
  const std::vector<Curve> large = {Curve::bezier(Points({{1e300}, {1}}), {1e10, 1})};
  EXPECT_THROW((void)format_itd(large), tandem::InvalidArgument);
}

}  // namespace
