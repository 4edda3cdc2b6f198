#include "tandem/rank/shape_descriptor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "rank/shapes.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace {

using tandem::Curve;
using tandem::describe;
using tandem::Points;
using tandem::Shape;
using tandem::ShapeDescriptor;
using namespace tandem::testing_rank;

TEST(ShapeDescriptor, HoldsUnitTangentsAndSharesOfTheLength) {
  const ShapeDescriptor square =
      describe(polygon({{0, 0}, {3, 0}, {3, 3}, {0, 3}}), {.samples = 40, .name = "a", .label = "b"});
  ASSERT_EQ(square.size(), 40U);
  EXPECT_TRUE(square.is_closed());
  EXPECT_TRUE(square.is_oriented());
  EXPECT_EQ(square.name(), "a");
  EXPECT_EQ(square.label(), "b");
  for (std::size_t k = 0; k < 40; ++k) {
    EXPECT_EQ(std::fabs(square.tangents()[k][0]) + std::fabs(square.tangents()[k][1]), 1.0);
    EXPECT_NEAR(square.lengths()[k], 1.0 / 40.0, 1e-8);
  }
}

TEST(ShapeDescriptor, IsTheSameForBothDirectionsOfAClosedPlanarCurve) {
  std::mt19937 random(41);
  for (int round = 0; round < 10; ++round) {
    const Curve shape = star(random);
    const ShapeDescriptor a = describe(shape);
    const ShapeDescriptor b = describe(tandem::reverse(shape));
    ASSERT_EQ(a.size(), b.size());
    // Their nodes are the same ones; where the row of nodes begins may differ.
    std::size_t shift = 0;
    for (std::size_t s = 0; s < a.size(); ++s) {
      double apart = 0.0;
      for (std::size_t k = 0; k < a.size(); ++k) {
        const auto x = a.tangents()[k];
        const auto y = b.tangents()[(k + s) % b.size()];
        apart = std::max(apart, std::fabs(x[0] - y[0]) + std::fabs(x[1] - y[1]));
      }
      if (apart < 1e-5) ++shift;
    }
    EXPECT_EQ(shift, 1U);
  }
}

TEST(ShapeDescriptor, AFigureEightHasNoOrientation) {
  EXPECT_FALSE(describe(polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}})).is_oriented());
}

TEST(ShapeDescriptor, ReadsBackEqualFromItsOwnParts) {
  std::mt19937 random(42);
  for (int round = 0; round < 20; ++round) {
    const ShapeDescriptor a = describe(round % 2 == 0 ? star(random) : wave(random, 3));
    EXPECT_EQ(ShapeDescriptor(a.is_closed(), a.tangents(), a.lengths()), a);
  }
}

TEST(ShapeDescriptor, TakesCurvesOfAnySize) {
  for (const double scale : {1e-300, 1e-20, 1e300}) {
    const ShapeDescriptor big = describe(polygon({{0, 0}, {scale, 0}, {scale, scale}}));
    EXPECT_NEAR(std::accumulate(big.lengths().begin(), big.lengths().end(), 0.0), 1.0, 1e-5);
  }
}

TEST(ShapeDescriptor, RefusesWhatIsNone) {
  const Points triangle({{1, 0}, {0, 1}, {-1, 0}});
  const double nan = std::nan("");
  EXPECT_THROW(ShapeDescriptor(true, Points({{1, 0}, {-1, 0}}), {0.5, 0.5}), tandem::InvalidArgument);
  EXPECT_THROW(ShapeDescriptor(true, triangle, {0.5, 0.5}), tandem::InvalidArgument);
  EXPECT_THROW(ShapeDescriptor(true, triangle, {0.5, 0.5, 0.0}), tandem::InvalidArgument);
  EXPECT_THROW(ShapeDescriptor(true, triangle, {0.5, 0.5, nan}), tandem::InvalidArgument);
  EXPECT_THROW(ShapeDescriptor(true, triangle, {0.5, 0.5, 1e308 * 10.0}), tandem::InvalidArgument);
  for (const double bad : {0.9, nan, 1e300})
    EXPECT_THROW(ShapeDescriptor(false, Points({{bad, 0}}), {1.0}), tandem::InvalidArgument);
  EXPECT_THROW((void)describe(polygon({{0, 0}, {1, 0}, {1, 1}}), {.samples = 2}), tandem::InvalidArgument);
  EXPECT_THROW((void)describe(polygon({{0, 0}, {0, 0}})), tandem::InvalidArgument);
  EXPECT_THROW((void)describe(Shape{}), tandem::InvalidArgument);
}

TEST(OuterContour, EnclosesTheLargestArea) {
  const Curve large = polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const Curve hole = tandem::reverse(polygon({{2, 2}, {4, 2}, {4, 4}, {2, 4}}));
  const Curve longer = polygon({{0, 0}, {100, 0}, {100, 0.1}, {0, 0.1}});
  const Curve open = Curve::bezier({{0, 0}, {1000, 0}});
  EXPECT_EQ(outer_contour(Shape{{hole, longer, open, large}}), 3U);
  EXPECT_EQ(outer_contour(Shape{{hole, tandem::reverse(large)}}), 1U);
  EXPECT_EQ(outer_contour(Shape{{large, large}}), 0U);
  EXPECT_EQ(outer_contour(Shape{{Curve::bezier({{0, 0}, {1, 0}}), open}}), 1U);
}

}  // namespace
