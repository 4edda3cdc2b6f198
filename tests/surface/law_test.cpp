#include "tandem/surface/law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tandem/error.h"

namespace tandem {
namespace {

/// v = u + depth * sin(2 pi u) / (2 pi), in steps.
FitPath wave(double depth, int points) {
  FitPath path;
  for (int i = 0; i <= points; ++i) {
    const double u = static_cast<double>(i) / points;
    path.points.push_back({u, u + depth * std::sin(2 * std::numbers::pi * u) / (2 * std::numbers::pi)});
  }
  path.points.front().v = 0.0;
  path.points.back().v = 1.0;
  return path;
}

void expect_increasing(const Curve& v) {
  for (std::size_t i = 1; i < v.size(); ++i) {
    EXPECT_LT(v.control_points()[i - 1][0], v.control_points()[i][0]);
  }
}

TEST(SmoothLaw, FollowsThePathWithFewKnots) {
  const FitPath path = wave(0.9, 200);
  for (const int order : {3, 4, 5}) {
    const Reparametrization law = smooth_law(path, {.order = order, .tolerance = 1e-4});
    EXPECT_LE(law.max_deviation, 1e-4);
    EXPECT_LT(law.v.size(), 40U);
    expect_increasing(law.v);
    for (const ParameterPair& point : path.points) EXPECT_NEAR(law.v.evaluate(point.u)[0], point.v, 1e-4);
  }
}

TEST(SmoothLaw, OfALoopRunsOnAcrossTheSeam) {
  FitPath path = wave(0.9, 200);
  // Steep at the seam: without the condition the two slopes would be fitted one by one.
  const Reparametrization law = smooth_law(path, {}, true);
  const double first = law.v.derivatives(0.0, 1)[1][0];
  const double last = law.v.derivatives(1.0, 1, Side::left)[1][0];
  EXPECT_NEAR(first, last, 1e-12);
  EXPECT_NEAR(first, 1.9, 0.1);
  expect_increasing(law.v);
  // A corner at the seam lets them differ.
  path.corner_parameters = {0.0};
  const Reparametrization cornered = smooth_law(path, {}, true);
  EXPECT_NE(cornered.v.derivatives(0.0, 1)[1][0], cornered.v.derivatives(1.0, 1, Side::left)[1][0]);
}

TEST(SmoothLaw, PassesThroughCornersExactly) {
  FitPath path;
  for (int i = 0; i <= 100; ++i) {
    const double u = i / 100.0;
    path.points.push_back({u, u < 0.4 ? 0.5 * u : 0.2 + (u - 0.4) * 0.8 / 0.6});
  }
  path.points.back().v = 1.0;
  path.corner_parameters = {path.points[40].u};
  const Reparametrization law = smooth_law(path);
  EXPECT_EQ(law.v.evaluate(path.points[40].u)[0], path.points[40].v);
  EXPECT_LT(law.max_deviation, 1e-9);
  EXPECT_NEAR(law.v.derivatives(path.points[40].u, 1, Side::left)[1][0], 0.5, 1e-6);
}

TEST(SmoothLaw, StaysIncreasingWhereThePathStandsStillOrJumps) {
  FitPath path;
  for (int i = 0; i <= 100; ++i) path.points.push_back({i / 100.0, i < 50 ? 0.0 : 1.0});
  const Reparametrization law = smooth_law(path);
  expect_increasing(law.v);
}

// Where a part of one curve has no counterpart the path jumps between two nodes.
TEST(SmoothLaw, FollowsAJump) {
  FitPath path;
  for (int i = 0; i <= 1000; ++i) path.points.push_back({0.001 * i, 0.0009 * i + (i > 400 ? 0.1 : 0.0)});
  path.points.back() = {1.0, 1.0};
  const Reparametrization law = smooth_law(path);
  EXPECT_LE(law.max_deviation, 1e-3);
  EXPECT_LT(law.v.size(), 80U);
  expect_increasing(law.v);
}

TEST(SmoothLaw, RefusesNonsense) {
  EXPECT_THROW(static_cast<void>(smooth_law(wave(0.5, 10), {.order = 1})), InvalidArgument);
  EXPECT_THROW(static_cast<void>(smooth_law(wave(0.5, 10), {.tolerance = 0.0})), InvalidArgument);
  EXPECT_THROW(static_cast<void>(smooth_law(FitPath{})), InvalidArgument);
}

}  // namespace
}  // namespace tandem
