#include "tandem/shape/transform.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "shape/trigonometry.h"
#include "tandem/error.h"

namespace tandem {
namespace {

double number() {
  return *rc::gen::inRange(-1000000, 1000000) / 1000.0;
}

Transform any_transform() {
  return {number(), number(), number(), number(), number(), number()};
}

TEST(Trigonometry, IsExactAtQuarterTurns) {
  for (int q = -9; q <= 9; ++q) {
    const CosSin t = cos_sin_degrees(90.0 * q);
    const int r = ((q % 4) + 4) % 4;
    EXPECT_EQ(t.cosine, r == 0 ? 1.0 : r == 2 ? -1.0 : 0.0) << q;
    EXPECT_EQ(t.sine, r == 1 ? 1.0 : r == 3 ? -1.0 : 0.0) << q;
  }
  EXPECT_EQ(cos_sin_degrees(360.0 * 4e15).cosine, 1.0);
}

TEST(Trigonometry, AgreesWithTheLibrary) {
  EXPECT_TRUE(rc::check([] {
    const double degrees = *rc::gen::inRange(-720000000, 720000000) / 1e6;
    const CosSin t = cos_sin_degrees(degrees);
    // The reference angle itself is rounded: 720 degrees in radians carry an error of 1e-15.
    const long double radians = static_cast<long double>(degrees) * std::numbers::pi_v<long double> / 180.0L;
    RC_ASSERT(std::fabs(t.cosine - static_cast<double>(cosl(radians))) <= 3e-16);
    RC_ASSERT(std::fabs(t.sine - static_cast<double>(sinl(radians))) <= 3e-16);
  }));
}

TEST(Trigonometry, HasNoAnswerForInfinity) {
  EXPECT_TRUE(std::isnan(cos_sin_degrees(std::numeric_limits<double>::infinity()).cosine));
  EXPECT_TRUE(std::isnan(cos_sin_degrees(std::numeric_limits<double>::quiet_NaN()).sine));
}

TEST(Transform, ProductAppliesTheRightFactorFirst) {
  EXPECT_TRUE(rc::check([] {
    const Transform outer = any_transform();
    const Transform inner = any_transform();
    const Vec2 p{number(), number()};
    const Vec2 at_once = (outer * inner)(p);
    const Vec2 in_turn = outer(inner(p));
    // Products of three numbers of up to 1e3 each.
    RC_ASSERT(std::fabs(at_once.x - in_turn.x) <= 1e-5);
    RC_ASSERT(std::fabs(at_once.y - in_turn.y) <= 1e-5);
  }));
}

TEST(Transform, RotationTurnsXTowardsY) {
  EXPECT_EQ(Transform::rotate_degrees(90.0)(Vec2{1.0, 0.0}), (Vec2{0.0, 1.0}));
  EXPECT_EQ(Transform::rotate_degrees(-270.0)(Vec2{1.0, 0.0}), (Vec2{0.0, 1.0}));
  EXPECT_EQ(Transform::rotate_degrees(180.0)(Vec2{3.0, 4.0}), (Vec2{-3.0, -4.0}));
  const Transform full = Transform::rotate_degrees(30.0) * Transform::rotate_degrees(330.0);
  EXPECT_NEAR(full.a, 1.0, 1e-15);
  EXPECT_NEAR(full.b, 0.0, 1e-15);
}

TEST(Transform, SkewsAsSvgSays) {
  const Vec2 p = Transform::skew_x_degrees(45.0)(Vec2{0.0, 2.0});
  EXPECT_NEAR(p.x, 2.0, 1e-15);
  EXPECT_EQ(p.y, 2.0);
  const Vec2 q = Transform::skew_y_degrees(45.0)(Vec2{2.0, 0.0});
  EXPECT_EQ(q.x, 2.0);
  EXPECT_NEAR(q.y, 2.0, 1e-15);
}

TEST(Transform, MapsControlPointsOfPlanarCurves) {
  const Curve line = Curve::bezier(Points({{0, 0}, {1, 2}}), {1.0, 2.0}, {3.0, 4.0});
  const Curve moved = transform(line, Transform::translate(10, 20) * Transform::scale(2, 3));
  EXPECT_EQ(moved, Curve::bezier(Points({{10, 20}, {12, 26}}), {1.0, 2.0}, {3.0, 4.0}));
  EXPECT_THROW((void)transform(Curve::bezier(Points({{0, 0, 0}, {1, 2, 3}})), Transform{}), InvalidArgument);
}

}  // namespace
}  // namespace tandem
