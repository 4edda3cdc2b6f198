#include "morph/detour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "match/cubic_paths.h"
#include "morph/loops.h"
#include "morph/measures.h"
#include "morph/step_blend.h"

namespace tandem {
namespace {

using cubics::largest_difference;
using detail::ContourDetour;
using detail::ContourEnds;
using detail::Detour;
using detail::PlanarFrame;
using detail::StepBlend;
using test::largest_turn;
using test::smooth_star;
using test::turned;

/// Control points on a circle of radius 1 with `ripple` times a wave of `waves` on it.
CubicPath circle(int waves, double ripple, std::size_t segments = 40) {
  const std::size_t n = 3 * segments;
  Points points(2, n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i % n) / static_cast<double>(n);
    const double r = 1.0 + ripple * std::cos(waves * angle);
    points[i][0] = r * std::cos(angle);
    points[i][1] = r * std::sin(angle);
  }
  return CubicPath(std::move(points), true);
}

CubicPath applied(const Detour& detour, double width, const CubicPath& path) {
  Points points = path.control_points();
  detour.apply(width, points.data());
  return CubicPath(std::move(points), path.is_closed());
}

/// The loop from its second joint on.
CubicPath restarted(const CubicPath& path) {
  const Points& from = path.control_points();
  const std::size_t n = from.size() - 1;
  Points points(2, n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t c = 0; c < 2; ++c) points[i][c] = from[(i + 3) % n][c];
  }
  return CubicPath(std::move(points), true);
}

/// The amplitude of a wave on a circle, from the radii of its control points.
double amplitude(const CubicPath& path, int waves) {
  const std::size_t n = path.control_points().size() - 1;
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto p = path.control_points()[i];
    sum += std::hypot(p[0], p[1]) *
           std::cos(2.0 * std::numbers::pi * waves * static_cast<double>(i) / static_cast<double>(n));
  }
  return 2.0 * sum / static_cast<double>(n);
}

TEST(Detour, OfNoWidthChangesNothing) {
  std::mt19937 random(1);
  const CubicPath a = smooth_star(random, 6);
  EXPECT_EQ(applied(Detour(a, a), 0.0, a), a);
}

// Odd and even numbers of points, whose elimination meets at a point or beside it.
TEST(Detour, DoesNotKnowWhereAPathStarts) {
  for (const std::size_t segments : {2, 3, 4, 5, 12}) {
    std::mt19937 random(7);
    const CubicPath a = smooth_star(random, segments);
    const CubicPath b = smooth_star(random, segments);
    const CubicPath here = restarted(applied(Detour(a, b), 0.03, a));
    const CubicPath there = applied(Detour(restarted(a), restarted(b)), 0.03, restarted(a));
    EXPECT_LE(largest_difference(here, there), 1e-13) << segments;
  }
}

TEST(Detour, SmoothsHighFrequenciesFirst) {
  const CubicPath a = circle(12, 0.05);
  const CubicPath low = circle(2, 0.05);
  double before_high = 0.05;
  double before_low = 0.05;
  for (const double width : {0.005, 0.01, 0.02, 0.04}) {
    const double high = std::fabs(amplitude(applied(Detour(a, a), width, a), 12));
    const double slow = std::fabs(amplitude(applied(Detour(low, low), width, low), 2));
    EXPECT_LT(high, before_high);
    EXPECT_LT(slow, before_low);
    EXPECT_LT(high, slow);
    before_high = high;
    before_low = slow;
  }
  // A Gaussian of this width takes exp(-(2 pi 12 width)^2 / 2) of such a wave; three implicit steps less.
  const double taken = std::pow(1.0 + 0.5 * std::pow(2.0 * std::numbers::pi * 12 * 0.02, 2) / 3.0, -3);
  EXPECT_NEAR(std::fabs(amplitude(applied(Detour(a, a), 0.02, a), 12)), 0.05 * taken, 0.005);
}

TEST(Detour, ChangesLittleWithALittleWidth) {
  std::mt19937 random(2);
  const CubicPath a = smooth_star(random, 6);
  const Detour detour(a, a);
  EXPECT_LT(largest_difference(applied(detour, 1e-5, a), a), 1e-6);
}

TEST(Detour, KeepsTheArea) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const CubicPath a = smooth_star(random, 8);
    const CubicPath b = smooth_star(random, 8);
    const CubicPath now = applied(Detour(a, b), 0.03, a);
    EXPECT_NEAR(detail::signed_area(now.control_points().data()),
                detail::signed_area(a.control_points().data()), 1e-12);
  }
}

TEST(Detour, KeepsSmoothJointsSmooth) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 20; ++trial) {
    const CubicPath a = smooth_star(random, 8);
    const CubicPath b = smooth_star(random, 8);
    for (const double width : {1e-3, 0.02, 0.1}) {
      EXPECT_LE(largest_turn(applied(Detour(a, b), width, a)), 1e-9);
    }
  }
}

TEST(Detour, MovesWithTheShape) {
  std::mt19937 random(5);
  const CubicPath a = smooth_star(random, 6);
  const CubicPath b = smooth_star(random, 6);
  const Detour detour(a, b);
  EXPECT_LT(largest_difference(applied(detour, 0.05, turned(a, 40.0, 5.0, -2.0)),
                               turned(applied(detour, 0.05, a), 40.0, 5.0, -2.0)),
            1e-12);
}

TEST(Detour, KeepsOpenEndsAndStraightLines) {
  const CubicPath line(Points({{0, 0}, {1, 1}, {2, 2}, {3, 3}, {3.5, 3.5}, {4, 4}, {7, 7}}));
  const CubicPath now = applied(Detour(line, line), 0.1, line);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR(now.control_points()[i][0], now.control_points()[i][1], 1e-12);
  }
  std::mt19937 random(6);
  const CubicPath a = cubics::random_path(random, 2, 5, false);
  const CubicPath smooth = applied(Detour(a, a), 0.1, a);
  for (const std::size_t end : {std::size_t{0}, a.control_points().size() - 1}) {
    EXPECT_NEAR(smooth.control_points()[end][0], a.control_points()[end][0], 1e-12);
    EXPECT_NEAR(smooth.control_points()[end][1], a.control_points()[end][1], 1e-12);
  }
  EXPECT_LT(detail::path_length(smooth.control_points().data()),
            detail::path_length(a.control_points().data()));
}

// On the way of a step: nothing at both ends, and no jump beside them.
TEST(Detour, StartsAndEndsWithTheShapes) {
  std::mt19937 random(7);
  const CubicPath a = smooth_star(random, 6);
  const CubicPath b = turned(smooth_star(random, 6), 0.0, 1.0, 0.0);
  const std::vector<ContourEnds> ends{{a, b}};
  const StepBlend plain(BlendKind::affine, PlanarFrame(), ends);
  for (const ContourDetour& detour : {ContourDetour{.width = 0.05}, ContourDetour{.shrink = 0.5},
                                      ContourDetour{.width = 0.0, .shrink = 0.2, .offset = {1.0, 2.0}}}) {
    StepBlend made(BlendKind::affine, PlanarFrame(), ends);
    made.set_detour(0, detour);
    EXPECT_FALSE(made.is_linear());
    const auto difference = [&](double s) {
      Points with(2, a.control_points().size());
      Points without = with;
      made.at(s, 0, with.data());
      plain.at(s, 0, without.data());
      return largest_difference(CubicPath(with), CubicPath(without));
    };
    for (const double end : {0.0, 1.0, -0.3, 1.2}) EXPECT_EQ(difference(end), 0.0);
    EXPECT_LT(difference(1e-4), 2e-3);
    EXPECT_LT(difference(1.0 - 1e-4), 2e-3);
    EXPECT_GT(difference(0.5), 1e-3);
  }
}

}  // namespace
}  // namespace tandem
