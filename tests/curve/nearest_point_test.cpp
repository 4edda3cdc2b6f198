#include "tandem/curve/nearest_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tandem/error.h"

namespace tandem {
namespace {

TEST(NearestPoint, IsTheFootOnALine) {
  const Curve line = Curve::clamped_uniform(1, Points({{0, 0}, {4, 0}, {4, 4}}));
  NearestPoint near = nearest_point(line, Point{1, 3});
  EXPECT_NEAR(near.parameter, 0.125, 1e-8);
  EXPECT_NEAR(near.distance, 3.0, 1e-15);
  near = nearest_point(line, Point{-3, -4});
  EXPECT_NEAR(near.parameter, 0.0, 1e-12);
  EXPECT_NEAR(near.distance, 5.0, 1e-12);
  near = nearest_point(line, Point{5, 3});
  EXPECT_NEAR(near.parameter, 0.875, 1e-8);
  EXPECT_NEAR(near.distance, 1.0, 1e-15);
}

TEST(NearestPoint, LiesOnTheRayOfACircle) {
  const double h = std::sqrt(0.5);
  const Curve circle(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
                     Points({{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}),
                     {1, h, 1, h, 1, h, 1, h, 1});
  for (double angle = 0.1; angle < 6.2; angle += 0.3) {
    const Point far = {3 * std::cos(angle), 3 * std::sin(angle)};
    const NearestPoint near = nearest_point(circle, far);
    EXPECT_NEAR(near.distance, 2.0, 1e-12);
    const Point p = circle.evaluate(near.parameter);
    EXPECT_NEAR(p[0], far[0] / 3, 1e-7);
    EXPECT_NEAR(p[1], far[1] / 3, 1e-7);
  }
}

TEST(NearestPoint, IsNoFartherThanAnySample) {
  std::mt19937 random(1);
  std::normal_distribution<double> number(0.0, 1.0);
  for (int trial = 0; trial < 50; ++trial) {
    Points points(3, 9);
    for (double& x : points.data()) x = number(random);
    const Curve curve = Curve::clamped_uniform(3, points);
    const Point from = {number(random), number(random), number(random)};
    const auto distance = [&](double t) {
      const Point p = curve.evaluate(t);
      return std::hypot(p[0] - from[0], p[1] - from[1], p[2] - from[2]);
    };
    const NearestPoint near = nearest_point(curve, from);
    EXPECT_NEAR(near.distance, distance(near.parameter), 1e-14);
    for (int k = 0; k <= 2000; ++k) EXPECT_LE(near.distance, distance(k / 2000.0) + 1e-14);
  }
}

TEST(NearestPoint, SaysWhatIsWrong) {
  const Curve line = Curve::clamped_uniform(1, Points({{0, 0}, {4, 0}}));
  EXPECT_THROW((void)nearest_point(line, Point{1, 2, 3}), InvalidArgument);
  EXPECT_THROW((void)nearest_point(line, Point{1, NAN}), InvalidArgument);
}

}  // namespace
}  // namespace tandem
