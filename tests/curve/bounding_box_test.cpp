#include "tandem/curve/bounding_box.h"

#include <gtest/gtest.h>

#include <cmath>

#include "curve/random_curves.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using testing::RandomCurves;

TEST(BoundingBox, ClosedForms) {
  const double h = std::sqrt(0.5);
  const Box arc = bounding_box(Curve::bezier(Points({{h, -h}, {2 * h, 0}, {h, h}}), {1, h, 1}));
  EXPECT_NEAR(arc.hi[0], 1.0, 4e-16);
  EXPECT_NEAR(arc.lo[0], h, 1e-16);
  const Box parabola = bounding_box(Curve::bezier(Points({{0, 0}, {1, 2}, {2, 0}})));
  EXPECT_NEAR(parabola.hi[1], 1.0, 4e-16);
  EXPECT_EQ(parabola.lo[1], 0.0);
  EXPECT_EQ(parabola.lo[0], 0.0);
  EXPECT_EQ(parabola.hi[0], 2.0);
}

TEST(BoundingBox, IsTightAroundSamples) {
  RandomCurves random(60);
  for (int i = 0; i < 60; ++i) {
    const Curve curve = random.any(2);
    const Box box = bounding_box(curve);
    Box seen;
    for (int k = 0; k <= 3000; ++k) {
      seen.include(curve.evaluate(curve.domain().lo + curve.domain().length() * k / 3000));
    }
    for (const double knot : curve.knots()) seen.include(curve.evaluate(knot));
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_LE(box.lo[c], seen.lo[c] + 1e-15);
      EXPECT_GE(box.hi[c], seen.hi[c] - 1e-15);
      // 3000 samples miss an extremum by a second-order amount, more in short spans.
      EXPECT_NEAR(box.lo[c], seen.lo[c], 2e-3);
      EXPECT_NEAR(box.hi[c], seen.hi[c], 2e-3);
    }
  }
}

TEST(BoundingBox, ConstantAndHuge) {
  const Box point = bounding_box(Curve::bezier(Points({{1, 2}, {1, 2}, {1, 2}})));
  EXPECT_EQ(point.lo, (Point{1, 2}));
  EXPECT_EQ(point.hi, (Point{1, 2}));
  EXPECT_EQ(point.diagonal(), 0.0);
  const Box huge = bounding_box(Curve::bezier(Points({{-1e300, 0}, {0, 2e300}, {1e300, 0}})));
  EXPECT_DOUBLE_EQ(huge.hi[1], 1e300);
  EXPECT_TRUE(std::isfinite(huge.diagonal()));
}

TEST(Box, GrowsAndRefusesOtherDimensions) {
  Box box;
  EXPECT_TRUE(box.empty());
  EXPECT_EQ(box.diagonal(), 0.0);
  box.include(Box{});
  EXPECT_TRUE(box.empty());
  box.include(Point{1, 1});
  box.include(Point{4, -3});
  EXPECT_EQ(box.diagonal(), 5.0);
  EXPECT_EQ(box.center(), (Point{2.5, -1}));
  EXPECT_THROW(box.include(Point{1}), InvalidArgument);
}

}  // namespace
}  // namespace tandem
