#include "tandem/rank/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rank/shapes.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace {

using tandem::CompareOptions;
using tandem::Comparison;
using tandem::Curve;
using tandem::describe;
using tandem::RankCost;
using tandem::ShapeDescriptor;
using namespace tandem::testing_rank;

constexpr RankCost kCosts[] = {RankCost::symmetric, RankCost::paper, RankCost::elastic};
/// Tangents are floats, and samples of a turned shape differ by the rounding of its points.
constexpr double kSame = 1e-5;

CompareOptions with(RankCost cost, bool rotate, bool mirror) {
  return {.cost = cost, .rotate = rotate, .mirror = mirror};
}

TEST(Compare, AShapeMovedScaledAndRestartedIsTheSame) {
  std::mt19937 random(1);
  for (int round = 0; round < 10; ++round) {
    const Curve shape = star(random);
    const Curve other = tandem::move_seam(moved(shape, 0.0, 37.5, -100.0, 3.0), 0.37);
    for (const RankCost cost : kCosts) {
      const Comparison c = compare(describe(shape, {.samples = 40}), describe(other, {.samples = 40}),
                                   with(cost, false, false));
      EXPECT_NEAR(c.cost, 0.0, kSame);
      EXPECT_TRUE(c.rotation.is_identity());
    }
  }
}

TEST(Compare, FindsTheTurn) {
  std::mt19937 random(2);
  for (int round = 0; round < 20; ++round) {
    const Curve shape = star(random);
    const double angle = uniform(random, -3.1, 3.1);
    const ShapeDescriptor a = describe(shape, {.samples = 40});
    const ShapeDescriptor b = describe(tandem::reverse(moved(shape, angle, 2.0, 1.0, 1.0)), {.samples = 40});
    for (const RankCost cost : kCosts) {
      const Comparison c = compare(a, b, with(cost, true, false));
      EXPECT_NEAR(c.cost, 0.0, kSame);
      EXPECT_NEAR(c.rotation.degrees(), angle * 180.0 / 3.141592653589793, 0.05);  // 1e-3 rad
      EXPECT_FALSE(c.mirrored);
    }
    EXPECT_GT(compare(a, b, with(RankCost::symmetric, false, false)).cost, 10.0 * kSame) << angle;
  }
}

TEST(Compare, FindsTheMirrorImage) {
  std::mt19937 random(3);
  for (int round = 0; round < 10; ++round) {
    const Curve shape = star(random);
    const ShapeDescriptor a = describe(shape, {.samples = 40});
    const ShapeDescriptor b = describe(moved(shape, 1.1, 0.5, 0.0, 9.0, true), {.samples = 40});
    for (const RankCost cost : kCosts) {
      const Comparison c = compare(a, b, with(cost, true, true));
      EXPECT_NEAR(c.cost, 0.0, kSame);
      EXPECT_TRUE(c.mirrored);
      EXPECT_NEAR(c.rotation.degrees(), 1.1 * 180.0 / 3.141592653589793, 0.05);
    }
    EXPECT_GT(compare(a, b, with(RankCost::symmetric, true, false)).cost, 100.0 * kSame);
  }
}

TEST(Compare, WithoutTurnsMirroredMeansFlippedLeftToRight) {
  std::mt19937 random(4);
  const Curve shape = star(random);
  const ShapeDescriptor a = describe(shape);
  const ShapeDescriptor flipped = describe(moved(shape, 0.0, 1.0, 0.0, 0.0, true));
  EXPECT_NEAR(compare(a, flipped, with(RankCost::symmetric, false, true)).cost, 0.0, kSame);
  EXPECT_GT(compare(a, flipped, with(RankCost::symmetric, false, false)).cost, 100.0 * kSame);
}

TEST(Compare, OpenCurvesRunEitherWayAndTurn) {
  std::mt19937 random(5);
  for (int round = 0; round < 10; ++round) {
    const Curve shape = wave(random);
    const ShapeDescriptor a = describe(shape, {.samples = 40});
    const ShapeDescriptor b = describe(tandem::reverse(moved(shape, 2.0, 3.0, 0.0, 0.0)), {.samples = 40});
    ASSERT_FALSE(a.is_closed());
    for (const RankCost cost : kCosts) {
      const Comparison c = compare(a, b, with(cost, true, false));
      EXPECT_NEAR(c.cost, 0.0, 1e-4);  // nodes of the reversed curve fall elsewhere by rounding of lengths
      EXPECT_TRUE(c.reversed);
    }
  }
}

TEST(Compare, TurnsInSpace) {
  std::mt19937 random(6);
  for (int round = 0; round < 10; ++round) {
    const Curve shape = wave(random, 3);
    tandem::Points points = shape.control_points();
    for (std::size_t i = 0; i < points.size(); ++i) {  // a third of a turn about (1, 1, 1)
      const double x = points[i][0];
      points[i][0] = points[i][1];
      points[i][1] = points[i][2];
      points[i][2] = x;
    }
    const Curve turned(shape.degree(), shape.knots(), std::move(points));
    const Comparison c = compare(describe(shape), describe(turned));
    EXPECT_NEAR(c.cost, 0.0, kSame);
    EXPECT_NEAR(c.rotation.degrees(), 120.0, 0.05);
  }
}

TEST(Compare, TheLimitChangesNothingButWhetherThereIsAnAnswer) {
  const std::vector<ShapeDescriptor> shapes = stars(12, 7, 30);
  for (const RankCost cost : kCosts) {
    for (const bool rotate : {false, true}) {
      const tandem::ShapeComparer comparer(shapes[0], with(cost, rotate, true));
      for (std::size_t k = 1; k < shapes.size(); ++k) {
        const Comparison all = *comparer.compare(shapes[k]);
        const auto same = comparer.compare(shapes[k], all.cost);
        ASSERT_TRUE(same);
        EXPECT_EQ(same->cost, all.cost);
        EXPECT_EQ(same->rotation, all.rotation);
        EXPECT_EQ(same->shift, all.shift);
        EXPECT_EQ(same->mirrored, all.mirrored);
        EXPECT_FALSE(comparer.compare(shapes[k], std::nextafter(all.cost, 0.0)));
      }
    }
  }
}

TEST(Compare, SamplesMayDiffer) {
  std::mt19937 random(8);
  const Curve shape = star(random);
  for (const RankCost cost : {RankCost::paper, RankCost::elastic}) {
    EXPECT_LT(
        compare(describe(shape, {.samples = 40}), describe(shape, {.samples = 65}), {.cost = cost}).cost,
        0.01);
  }
}

TEST(Compare, RefusesWhatCannotBeCompared) {
  std::mt19937 random(9);
  const ShapeDescriptor closed = describe(star(random));
  const ShapeDescriptor open = describe(wave(random));
  const ShapeDescriptor space = describe(wave(random, 3));
  EXPECT_THROW((void)compare(closed, open), tandem::InvalidArgument);
  EXPECT_THROW((void)compare(open, space), tandem::InvalidArgument);
  EXPECT_THROW((void)compare(open, open, {.charge = -1.0}), tandem::InvalidArgument);
  EXPECT_THROW((void)compare(open, open, {.charge = std::nan("")}), tandem::InvalidArgument);
}

}  // namespace
