#include "tandem/shape/cubic_path.h"

#include <gtest/gtest.h>

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
