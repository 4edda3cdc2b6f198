#include "tandem/shape/cubic_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tandem/error.h"
#include "tandem/shape/shape.h"

namespace tandem {
namespace {

TEST(CubicPath, SaysWhatIsWrong) {
  EXPECT_THROW(CubicPath(Points({{0, 0}})), InvalidArgument);
  EXPECT_THROW(CubicPath(Points({{0, 0}, {1, 0}, {2, 0}})), InvalidArgument);
  EXPECT_THROW(CubicPath(Points{}), InvalidArgument);
  EXPECT_THROW(CubicPath(Points({{0, 0}, {1, 0}, {2, 0}, {3, 0}}), true), InvalidArgument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CubicPath(Points({{0, 0}, {1, nan}, {2, 0}, {3, 0}})), InvalidArgument);
  EXPECT_NO_THROW(CubicPath(Points({{0, 0}, {1, 0}, {0, 1}, {0, 0}}), true));
}

TEST(CubicPath, KnowsConstantSpeedLines) {
  const CubicPath path(
      Points({{0, 0}, {1, 1}, {2, 2}, {3, 3}, {3, 3}, {9, 9}, {9, 9}, {9, 9}, {9, 9}, {9, 9}}));
  EXPECT_EQ(path.segment_count(), 3u);
  EXPECT_TRUE(path.is_line(0, 0.0));
  EXPECT_FALSE(path.is_line(1, 1e-3));  // straight, but its speed changes
  EXPECT_TRUE(path.is_line(2, 0.0));
  const CubicPath bent(Points({{0, 0}, {1, 1}, {2, 2.01}, {3, 3}}));
  EXPECT_FALSE(bent.is_line(0, 0.009));
  EXPECT_TRUE(bent.is_line(0, 0.011));
}

TEST(CubicPath, IsTheSameCurveWithTripleKnots) {
  const CubicPath path(Points({{0, 0}, {1, 3}, {2, -1}, {3, 3}, {4, 0}, {6, 1}, {8, 8}}));
  const Curve curve = to_curve(path);
  EXPECT_EQ(curve.degree(), 3);
  EXPECT_EQ(curve.knots(), (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}));
  EXPECT_EQ(curve.control_points(), path.control_points());
  const Point middle = curve.evaluate(1.5);
  EXPECT_NEAR(middle[0], (3 + 3 * 4 + 3 * 6 + 8) / 8.0, 1e-15);
  EXPECT_NEAR(middle[1], (3 + 3 * 0 + 3 * 1 + 8) / 8.0, 1e-15);
}

TEST(CubicPath, TakesCurvesOfLowDegreeExactly) {
  for (int degree = 1; degree <= 3; ++degree) {
    const Curve curve =
        Curve::clamped_uniform(degree, Points({{0, 0}, {2, 5}, {5, 5}, {8, 1}, {9, -3}, {4, -5}}));
    const CubicPath path = to_cubic_path(curve, 1e-3);
    const Curve drawn = to_curve(path);
    EXPECT_FALSE(path.is_closed());
    EXPECT_EQ(path.segment_count(), 6u - static_cast<std::size_t>(degree));
    const double spans = static_cast<double>(path.segment_count());
    for (int i = 0; i <= 100; ++i) {
      const Point p = curve.evaluate(i / 100.0);
      const Point q = drawn.evaluate(i / 100.0 * spans);
      EXPECT_NEAR(p[0], q[0], 1e-14);
      EXPECT_NEAR(p[1], q[1], 1e-14);
    }
    for (std::size_t k = 0; degree == 1 && k < path.segment_count(); ++k) EXPECT_TRUE(path.is_line(k, 1e-15));
  }
}

TEST(CubicPath, FollowsOtherCurvesWithinTheTolerance) {
  const double w = std::sqrt(0.5);
  const Curve quarter = Curve::bezier(Points({{1, 0}, {1, 1}, {0, 1}}), {1, w, 1});
  const Curve quintic = Curve::bezier(Points({{0, 0}, {3, 9}, {-4, 2}, {7, -8}, {1, 1}, {5, 5}}));
  std::size_t segments = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const CubicPath arc = to_cubic_path(quarter, tolerance);
    for (int i = 0; i <= 1000; ++i) {
      const Point p = to_curve(arc).evaluate(i / 1000.0 * static_cast<double>(arc.segment_count()));
      EXPECT_NEAR(std::sqrt(p[0] * p[0] + p[1] * p[1]), 1.0, tolerance);
    }
    const CubicPath wave = to_cubic_path(quintic, tolerance);
    EXPECT_GT(wave.segment_count(), segments);
    segments = wave.segment_count();
    EXPECT_EQ(wave.control_points().back()[0], 5.0);
  }
  EXPECT_LE(segments, 512u);
  EXPECT_THROW((void)to_cubic_path(quintic, 0.0), InvalidArgument);
}

TEST(CubicPath, ClosedCurvesBecomeClosedPaths) {
  const Curve loop = Curve::bezier(Points({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1e-13, -1e-13}}));
  ASSERT_TRUE(loop.is_closed());
  EXPECT_TRUE(to_cubic_path(loop, 1e-4).is_closed());
}

TEST(CubicPath, EndsOnHostileWeights) {
  const Curve sharp = Curve::bezier(Points({{0, 0}, {1, 1}, {2, 0}}), {1, 1e-12, 1e12});
  EXPECT_LE(to_cubic_path(sharp, 1e-12).segment_count(), 65536u);
  const Curve far = Curve::bezier(Points({{1e9, 0}, {1e9 + 1, 1}, {1e9, 2}}), {1, 2, 1});
  EXPECT_LE(to_cubic_path(far, 1e-12).segment_count(), 64u);
}

TEST(Shape, CollectsPathsAndTheirBox) {
  const CubicPath arch(Points({{0, 0}, {0, 4}, {4, 4}, {4, 0}}));
  const CubicPath line(Points({{9, -1}, {9, -2}, {9, -3}, {9, -4}}));
  const Shape shape = to_shape(std::vector<CubicPath>{arch, line}, FillRule::evenodd);
  EXPECT_EQ(shape.dim(), 2);
  EXPECT_EQ(shape.fill_rule, FillRule::evenodd);
  ASSERT_EQ(shape.contours.size(), 2u);
  const Box box = bounding_box(shape);
  EXPECT_NEAR(box.lo[0], 0, 1e-12);
  EXPECT_NEAR(box.lo[1], -4, 1e-12);
  EXPECT_NEAR(box.hi[0], 9, 1e-12);
  EXPECT_NEAR(box.hi[1], 3, 1e-12);  // of the curve, not of its control points
  EXPECT_EQ(Shape{}.dim(), 0);
  EXPECT_TRUE(bounding_box(Shape{}).empty());
}

}  // namespace
}  // namespace tandem
