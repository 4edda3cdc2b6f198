#include "morph/intrinsic_blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "match/cubic_paths.h"
#include "morph/loops.h"

namespace tandem {
namespace {

using cubics::largest_difference;
using cubics::random_path;
using detail::IntrinsicBlend;
using test::edge_length;
using test::largest_turn;
using test::smooth_star;
using test::turned;

const std::vector<double> kTimes = {0.0, 1e-3, 0.2, 0.5, 0.7, 0.999, 1.0};

CubicPath at(const IntrinsicBlend& blend, const CubicPath& like, double s) {
  Points points = like.control_points();
  blend.at(s, points.data());
  // What is left open is rounding; ClosesLoops sees to that.
  if (like.is_closed()) {
    points[points.size() - 1][0] = points[0][0];
    points[points.size() - 1][1] = points[0][1];
  }
  return CubicPath(std::move(points), like.is_closed());
}

TEST(IntrinsicBlend, EndsAtItsInputs) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const bool closed = trial % 2 == 0;
    const CubicPath a = random_path(random, 2, 5, closed);
    const CubicPath b = random_path(random, 2, 5, closed);
    const IntrinsicBlend blend(a, b);
    EXPECT_LT(largest_difference(at(blend, a, 0.0), a), 1e-12);
    EXPECT_LT(largest_difference(at(blend, a, 1.0), b), 1e-12);
  }
}

TEST(IntrinsicBlend, ClosesLoops) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    // Wild loops, too, in which lengths have to give a lot.
    const CubicPath a = trial % 2 == 0 ? smooth_star(random, 6) : random_path(random, 2, 6, true);
    const CubicPath b = trial % 2 == 0 ? smooth_star(random, 6) : random_path(random, 2, 6, true);
    const IntrinsicBlend blend(a, b);
    for (const double s : kTimes) {
      Points points(2, a.control_points().size());
      blend.at(s, points.data());
      const std::size_t last = points.size() - 1;
      EXPECT_NEAR(points[last][0], points[0][0], 1e-12);
      EXPECT_NEAR(points[last][1], points[0][1], 1e-12);
    }
  }
}

TEST(IntrinsicBlend, PreservesIdentity) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const CubicPath a = random_path(random, 2, 5, trial % 2 == 0);
    const IntrinsicBlend blend(a, a);
    for (const double s : kTimes) EXPECT_LT(largest_difference(at(blend, a, s), a), 1e-12);
  }
}

TEST(IntrinsicBlend, MovesTranslationsAtUniformSpeed) {
  std::mt19937 random(4);
  const CubicPath a = smooth_star(random, 6);
  const IntrinsicBlend blend(a, turned(a, 0.0, 7.0, -3.0));
  for (const double s : kTimes) {
    EXPECT_LT(largest_difference(at(blend, a, s), turned(a, 0.0, 7.0 * s, -3.0 * s)), 1e-12);
  }
}

// A turned copy stays a copy, and turns evenly about a centre that moves straight.
TEST(IntrinsicBlend, TurnsCopiesRigidly) {
  std::mt19937 random(5);
  for (const double degrees : {30.0, -90.0, 170.0}) {
    for (const bool closed : {true, false}) {
      const CubicPath a = closed ? smooth_star(random, 6) : random_path(random, 2, 4, false);
      const CubicPath b = turned(a, degrees, 2.0, 1.0);
      const IntrinsicBlend blend(a, b);
      for (const double s : kTimes) {
        const CubicPath now = at(blend, a, s);
        const CubicPath wanted = turned(a, s * degrees);
        const double dx = now.control_points()[0][0] - wanted.control_points()[0][0];
        const double dy = now.control_points()[0][1] - wanted.control_points()[0][1];
        EXPECT_LT(largest_difference(now, turned(a, s * degrees, dx, dy)), 1e-11) << degrees << " at " << s;
      }
    }
  }
}

TEST(IntrinsicBlend, KeepsSmoothJointsSmooth) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 100; ++trial) {
    const CubicPath a = smooth_star(random, 7);
    const CubicPath b = smooth_star(random, 7);
    const IntrinsicBlend blend(a, b);
    for (const double s : kTimes) EXPECT_LE(largest_turn(at(blend, a, s)), 1e-9) << s;
  }
}

TEST(IntrinsicBlend, KeepsLengthsPositive) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 100; ++trial) {
    const CubicPath a = random_path(random, 2, 6, true);
    const CubicPath b = turned(random_path(random, 2, 6, true), 90.0 * (trial % 4));
    const IntrinsicBlend blend(a, b);
    for (const double s : kTimes) {
      const CubicPath now = at(blend, a, s);
      const Points& p = now.control_points();
      for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        EXPECT_GT(edge_length(p, i), 0.0) << "edge " << i << " at " << s;
      }
    }
  }
}

// Of open paths nothing has to close: lengths and turns are exactly what they should be.
TEST(IntrinsicBlend, BendsArms) {
  const CubicPath arm(Points({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}, {6, 0}}));
  const CubicPath bent(Points({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {3, 3}}));
  const IntrinsicBlend blend(arm, bent);
  for (const double s : kTimes) {
    const CubicPath now = at(blend, arm, s);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(edge_length(now.control_points(), i), 1.0, 1e-12);
    EXPECT_NEAR(test::turn_at(now, 1), s * std::acos(-1.0) / 2.0, 1e-12);
  }
}

// A handle that lies on its joint grows into the direction in which the segment leaves.
TEST(IntrinsicBlend, GivesADirectionToEdgesOfNoLength) {
  const CubicPath a(Points({{0, 0}, {0, 0}, {3, 1}, {4, 0}}));
  const CubicPath b(Points({{0, 0}, {1, 1}, {3, 1}, {4, 0}}));
  const IntrinsicBlend blend(a, b);
  const Points p = at(blend, a, 1e-6).control_points();
  const double heading = std::atan2(p[1][1] - p[0][1], p[1][0] - p[0][0]);
  EXPECT_NEAR(heading, std::atan2(1.0, 3.0), 1e-5);
  // The same at the end of a segment, and where a whole segment is a point.
  const CubicPath c(Points({{0, 0}, {1, 0}, {2, 1}, {2, 1}, {2, 1}, {2, 1}, {2, 1}}));
  const CubicPath d(Points({{0, 0}, {1, 0}, {2, 1}, {3, 2}, {4, 3}, {5, 4}, {6, 5}}));
  const Points q = at(IntrinsicBlend(c, d), c, 0.5).control_points();
  for (std::size_t i = 2; i < 6; ++i) {
    EXPECT_NEAR(std::atan2(q[i + 1][1] - q[i][1], q[i + 1][0] - q[i][0]), std::acos(-1.0) / 4.0, 1e-12);
  }
}

TEST(IntrinsicBlend, GrowsFromAPoint) {
  std::mt19937 random(8);
  const CubicPath b = smooth_star(random, 5);
  const CubicPath a(Points(2, std::vector<double>(b.control_points().data().size(), 3.0)), true);
  const IntrinsicBlend blend(a, b);
  for (const double s : kTimes) {
    Points points(2, a.control_points().size());
    blend.at(s, points.data());
    // Evenly.
    const auto p = b.control_points();
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(points[i][0] - points[0][0], s * (p[i][0] - p[0][0]), 1e-12);
      EXPECT_NEAR(points[i][1] - points[0][1], s * (p[i][1] - p[0][1]), 1e-12);
    }
  }
  EXPECT_LT(largest_difference(at(blend, a, 0.0), a), 1e-12);
  EXPECT_LT(largest_difference(at(blend, a, 1.0), b), 1e-12);
}

}  // namespace
}  // namespace tandem
