#include "tandem/morph/segment_blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "match/cubic_paths.h"
#include "tandem/error.h"
#include "tandem/match/segments.h"

namespace tandem {
namespace {

using cubics::largest_difference;
using cubics::moved;
using cubics::random_path;
using cubics::smooth_loop;

Point minus(std::span<const double> x, std::span<const double> y) {
  Point z(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) z[k] = x[k] - y[k];
  return z;
}

double length(const Point& x) {
  double sum = 0.0;
  for (double c : x) sum += c * c;
  return std::sqrt(sum);
}

/// The angle between two vectors, in radians.
double angle(Point x, Point y) {
  const double p = length(x);
  const double q = length(y);
  for (double& c : x) c /= p;
  for (double& c : y) c /= q;
  double sum = 0.0;
  double gap = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    sum += (x[k] + y[k]) * (x[k] + y[k]);
    gap += (x[k] - y[k]) * (x[k] - y[k]);
  }
  return 2.0 * std::atan2(std::sqrt(gap), std::sqrt(sum));
}

/// How far the tangent turns at joint j.
double turn_at(const CubicPath& path, std::size_t j) {
  const Points& p = path.control_points();
  const std::size_t before = j == 0 ? p.size() - 2 : 3 * j - 1;
  return angle(minus(p[3 * j], p[before]), minus(p[3 * j + 1], p[3 * j]));
}

double largest_turn(const CubicPath& path) {
  double most = 0.0;
  for (std::size_t j = path.is_closed() ? 0 : 1; j < path.segment_count(); ++j) {
    most = std::max(most, turn_at(path, j));
  }
  return most;
}

const std::vector<double> kTimes = {0.0, 1e-3, 0.2, 0.499, 0.5, 0.7, 0.999, 1.0};

TEST(BezierBlend, MovesControlPointsOnStraightLines) {
  const CubicPath a(Points({{0, 0}, {1, 2}, {3, 4}, {5, 6}}));
  const CubicPath b(Points({{4, 0}, {1, 6}, {3, 0}, {5, -2}}));
  EXPECT_EQ(bezier_blend(a, b, 0.25), CubicPath(Points({{1, 0}, {1, 3}, {3, 3}, {5, 4}})));
  EXPECT_EQ(bezier_blend(a, b, 0.0), a);
  EXPECT_EQ(bezier_blend(a, b, 1.0), b);
}

TEST(HermiteBlend, IsThePapersFormula) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const int dim = 2 + trial % 2;
    const CubicPath a = random_path(random, dim, 1, false);
    const CubicPath b = random_path(random, dim, 1, false);
    const auto [p0, p1, p2, p3] = a.segment(0);
    const auto [q0, q1, q2, q3] = b.segment(0);
    const Point v0 = minus(p1, p0);
    const Point w0 = minus(q1, q0);
    const Point v3 = minus(p3, p2);
    const Point w3 = minus(q3, q2);
    if (angle(v0, w0) > 2.9 || angle(v3, w3) > 2.9) continue;
    const HermiteBlend blend(a, b);
    for (const double s : {0.0, 0.3, 0.8, 1.0}) {
      const auto formula = [&](const Point& v, const Point& w, std::size_t k) {
        Point mean(v.size());
        for (std::size_t d = 0; d < mean.size(); ++d)
          mean[d] = (1 - s) * v[d] / length(v) + s * w[d] / length(w);
        return ((1 - s) * length(v) + s * length(w)) * mean[k] / length(mean);
      };
      const CubicPath at = blend.at(s);
      const auto [r0, r1, r2, r3] = at.segment(0);
      for (std::size_t k = 0; k < p0.size(); ++k) {
        const double start = (1 - s) * p0[k] + s * q0[k];
        const double end = (1 - s) * p3[k] + s * q3[k];
        EXPECT_NEAR(r0[k], start, 1e-14);
        EXPECT_NEAR(r3[k], end, 1e-14);
        EXPECT_NEAR(r1[k], start + formula(v0, w0, k), 1e-12);
        EXPECT_NEAR(r2[k], end - formula(v3, w3, k), 1e-12);
      }
    }
  }
}

// [D]'s criteria (spec D7).

TEST(HermiteBlend, PreservesIdentity) {
  std::mt19937 random(2);
  for (const int dim : {2, 3, 5}) {
    const CubicPath a = random_path(random, dim, 6, true);
    const HermiteBlend blend(a, a);
    for (const double s : kTimes) EXPECT_LT(largest_difference(blend.at(s), a), 1e-14);
  }
}

TEST(HermiteBlend, MovesTranslationsAtUniformSpeed) {
  std::mt19937 random(3);
  const CubicPath a = random_path(random, 2, 6, true);
  const SegmentMatch match = match_segments(a, moved(a, 7.0));
  const HermiteBlend blend(match.a, match.b);
  for (const double s : kTimes) EXPECT_LT(largest_difference(blend.at(s), moved(a, 7.0 * s)), 1e-13);
}

TEST(HermiteBlend, KeepsSmoothJointsSmoothWhereTheBezierFormDoesNot) {
  std::mt19937 random(4);
  double worst_bezier = 0.0;
  for (int trial = 0; trial < 200; ++trial) {
    const int dim = 2 + trial % 2;
    const CubicPath a = smooth_loop(random, dim, 5);
    const CubicPath b = smooth_loop(random, dim, 5);
    const HermiteBlend blend(a, b);
    for (const double s : kTimes) {
      EXPECT_LE(largest_turn(blend.at(s)), 1e-9);
      worst_bezier = std::max(worst_bezier, largest_turn(bezier_blend(a, b, s)));
    }
  }
  EXPECT_GT(worst_bezier, 1.0);
}

TEST(HermiteBlend, KeepsMatchedLoopsSmooth) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    const CubicPath a = smooth_loop(random, 2 + trial % 2, 5);
    const CubicPath b = smooth_loop(random, 2 + trial % 2, 8);
    const SegmentMatch match = match_segments(a, b);
    const HermiteBlend blend(match.a, match.b);
    for (const double s : kTimes) EXPECT_LE(largest_turn(blend.at(s)), 1e-9);
  }
}

/// A loop whose joints turn by up to `rough` rad.
CubicPath roughened(std::mt19937& random, const CubicPath& loop, double rough) {
  std::normal_distribution<double> number(0.0, 1.0);
  Points points = loop.control_points();
  for (std::size_t j = 0; j < loop.segment_count(); ++j) {
    Point handle = minus(points[3 * j + 1], points[3 * j]);
    const double arm = length(handle);
    Point noise(handle.size());
    for (double& x : noise) x = number(random);
    const double size = length(noise);
    for (std::size_t k = 0; k < handle.size(); ++k) {
      points[3 * j + 1][k] += 0.9 * rough * arm * noise[k] / size;
    }
  }
  return CubicPath(std::move(points), true);
}

TEST(HermiteBlend, MakesNoJointRougherThanTheRougherInput) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 200; ++trial) {
    const int dim = 2 + trial % 2;
    const CubicPath a = roughened(random, smooth_loop(random, dim, 5), 1e-3);
    const CubicPath b = roughened(random, smooth_loop(random, dim, 5), 1e-3);
    const HermiteBlend blend(a, b);
    for (const double s : {-0.5, 0.1, 0.5, 0.77, 1.5}) {
      const CubicPath at = blend.at(s);
      for (std::size_t j = 0; j < 5; ++j) {
        const Points& p = at.control_points();
        const std::size_t before = j == 0 ? p.size() - 2 : 3 * j - 1;
        if (length(minus(p[3 * j + 1], p[3 * j])) < 1e-9 || length(minus(p[3 * j], p[before])) < 1e-9)
          continue;
        EXPECT_LE(turn_at(at, j), std::max(turn_at(a, j), turn_at(b, j)) + 1e-12);
      }
    }
  }
}

/// Two arcs that meet smoothly at the origin in direction `degrees`.
CubicPath smooth_at_origin(double degrees, double bend) {
  const double c = std::cos(degrees * std::numbers::pi / 180.0);
  const double s = std::sin(degrees * std::numbers::pi / 180.0);
  return CubicPath(Points({{-3 * c - bend * s, -3 * s + bend * c},
                           {-2 * c, -2 * s},
                           {-c, -s},
                           {0, 0},
                           {c, s},
                           {2 * c, 2 * s},
                           {3 * c - bend * s, 3 * s + bend * c}}));
}

TEST(HermiteBlend, TurnsOppositeDirectionsEvenly) {
  const CubicPath a = smooth_at_origin(0, 1);
  for (const double opposite : {180.0, 179.999, 180.001, 175.0, -175.0}) {
    const HermiteBlend blend(a, smooth_at_origin(opposite, 1));
    double last = 0.0;
    for (int i = 0; i <= 100; ++i) {
      const CubicPath at = blend.at(i / 100.0);
      EXPECT_LE(turn_at(at, 1), 1e-9);
      const Points& p = at.control_points();
      const double turned = angle(minus(p[4], p[3]), Point{1, 0});
      EXPECT_NEAR(turned - last, i == 0 ? 0.0 : std::numbers::pi * 1.8 / 180.0, 2e-3) << opposite;
      EXPECT_GT(length(minus(p[4], p[3])), 0.99);
      last = turned;
    }
  }
}

TEST(HermiteBlend, TurnsBothSidesOfACornerInOneSense) {
  // The way in turns back exactly, the way out by -170 degrees: both go the negative way round.
  const double x = std::cos(-170 * std::numbers::pi / 180);
  const double y = std::sin(-170 * std::numbers::pi / 180);
  const CubicPath a(Points({{0, -2}, {0, -1.5}, {0, -1}, {0, 0}, {1, 0}, {2, 1}, {3, 0}}));
  const CubicPath b(Points({{0, 2}, {0.5, 1.5}, {0, 1}, {0, 0}, {x, y}, {-2, 0}, {-3, 0}}));
  const CubicPath half = HermiteBlend(a, b).at(0.5);
  EXPECT_GT(minus(half.control_points()[3], half.control_points()[2])[0], 0.9);
  EXPECT_LT(minus(half.control_points()[4], half.control_points()[3])[1], -0.9);
  // In space the plane of the certain side decides.
  const auto lifted = [](const CubicPath& path, bool flip) {
    Points points(3, path.control_points().size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i][0] = path.control_points()[i][flip ? 1 : 0];
      points[i][2] = path.control_points()[i][flip ? 0 : 1];
    }
    return CubicPath(std::move(points));
  };
  const CubicPath space = HermiteBlend(lifted(a, false), lifted(b, false)).at(0.5);
  EXPECT_GT(minus(space.control_points()[3], space.control_points()[2])[0], 0.9);
  EXPECT_NEAR(space.control_points()[2][1], 0.0, 1e-15);
}

TEST(HermiteBlend, GivesADirectionToHandlesOfNoLength) {
  const CubicPath a(Points({{0, 0}, {0, 0}, {1, 1}, {2, 0}}));
  const CubicPath b(Points({{0, 0}, {0, 1}, {2, 1}, {2, 0}}));
  const CubicPath half = HermiteBlend(a, b).at(0.5);
  // From (1,1) / sqrt 2 to (0,1), from length 0 to 1.
  const Point mean = {std::sqrt(0.5), std::sqrt(0.5) + 1.0};
  EXPECT_NEAR(half.control_points()[1][0], 0.5 * mean[0] / length(mean), 1e-15);
  EXPECT_NEAR(half.control_points()[1][1], 0.5 * mean[1] / length(mean), 1e-15);
}

TEST(HermiteBlend, GrowsFromAPoint) {
  std::mt19937 random(7);
  const CubicPath a = smooth_loop(random, 2, 4);
  const CubicPath point(Points(2, 13), true);
  const HermiteBlend blend(point, a);
  for (const double s : kTimes) {
    for (std::size_t k = 0; k < 26; ++k) {
      EXPECT_NEAR(blend.at(s).control_points().data()[k], s * a.control_points().data()[k], 1e-14);
    }
  }
}

CubicPath polyline(const std::vector<std::pair<double, double>>& corners, bool closed) {
  Points points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto [x, y] = corners[i];
    if (i > 0) {
      const auto [x0, y0] = corners[i - 1];
      points.push_back(Point{x0 + (x - x0) / 3, y0 + (y - y0) / 3});
      points.push_back(Point{x + (x0 - x) / 3, y + (y0 - y) / 3});
    }
    points.push_back(Point{x, y});
  }
  return CubicPath(std::move(points), closed);
}

TEST(HermiteBlend, KeepsPolygonsPolygons) {
  const CubicPath a = polyline({{0, 0}, {4, 0}, {4, 1}, {0, 3}, {0, 0}}, true);
  const CubicPath b = polyline({{3, 0}, {3, 4}, {1, 3}, {0, 0}, {3, 0}}, true);
  const HermiteBlend blend(a, b);
  for (const double s : {-1.0, 0.0, 0.3, 0.5, 1.0, 2.0}) {
    const CubicPath at = blend.at(s);
    EXPECT_LT(largest_difference(at, bezier_blend(a, b, s)), 1e-14);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(blend.is_straight(i) && at.is_line(i, 1e-14));
  }
}

TEST(HermiteBlend, LeadsCurvesSmoothlyIntoLinesThatTurn) {
  // A line, then an arc that leaves it smoothly; in the other path elsewhere, turned, and of other lengths.
  const CubicPath a(Points({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 1}, {5, 2}}));
  const CubicPath b(Points({{0, 0}, {0, 2}, {0, 4}, {0, 6}, {0, 7}, {-1, 8}, {-2, 8}}));
  const HermiteBlend blend(a, b);
  EXPECT_TRUE(blend.is_straight(0));
  EXPECT_FALSE(blend.is_straight(1));
  for (const double s : kTimes) {
    const CubicPath at = blend.at(s);
    EXPECT_TRUE(at.is_line(0, 1e-14));
    EXPECT_LE(turn_at(at, 1), 1e-9);
  }
}

TEST(HermiteBlend, BendsLinesOnlyWhereTheirJointWouldBreak) {
  const CubicPath a = polyline({{0, 0}, {1, 0}, {4, 0}}, false);
  const CubicPath same_ratio = polyline({{0, 0}, {0, 2}, {0, 8}}, false);
  const CubicPath other_ratio = polyline({{0, 0}, {0, 4}, {0, 8}}, false);
  const CubicPath no_turn = polyline({{0, 1}, {2, 1}, {4, 1}}, false);
  const CubicPath corner = polyline({{0, 0}, {0, 4}, {1, 8}}, false);
  for (const CubicPath* b : {&same_ratio, &no_turn, &corner}) {
    const HermiteBlend blend(a, *b);
    EXPECT_TRUE(blend.is_straight(0) && blend.is_straight(1));
  }
  const HermiteBlend bent(a, other_ratio);
  EXPECT_FALSE(bent.is_straight(0) || bent.is_straight(1));
  for (const double s : kTimes) EXPECT_LE(turn_at(bent.at(s), 1), 1e-9);
}

TEST(HermiteBlend, ExtrapolatesWithoutExploding) {
  std::mt19937 random(8);
  for (int trial = 0; trial < 50; ++trial) {
    const CubicPath a = random_path(random, 2 + trial % 2, 5, trial % 3 == 0);
    const CubicPath b = random_path(random, 2 + trial % 2, 5, trial % 3 == 0);
    const HermiteBlend blend(a, b);
    for (const double s : {-10.0, -1.0, -0.2, 1.2, 3.0, 10.0}) {
      const CubicPath at = blend.at(s);
      for (double x : at.control_points().data()) EXPECT_LT(std::fabs(x), 60.0 * (1 + std::fabs(s)));
    }
  }
}

TEST(HermiteBlend, EndsAtItsInputs) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 50; ++trial) {
    const CubicPath a = random_path(random, 2 + trial % 3, 4, trial % 2 == 0);
    const CubicPath b = random_path(random, 2 + trial % 3, 4, trial % 2 == 0);
    const HermiteBlend blend(a, b);
    EXPECT_LT(largest_difference(blend.at(0.0), a), 1e-13);
    EXPECT_LT(largest_difference(blend.at(1.0), b), 1e-13);
  }
}

TEST(HermiteBlend, SaysWhatIsWrong) {
  std::mt19937 random(10);
  const CubicPath a = random_path(random, 2, 3, true);
  EXPECT_THROW(HermiteBlend(a, random_path(random, 2, 4, true)), InvalidArgument);
  EXPECT_THROW(HermiteBlend(a, random_path(random, 2, 3, false)), InvalidArgument);
  EXPECT_THROW(HermiteBlend(a, random_path(random, 3, 3, true)), InvalidArgument);
  EXPECT_THROW((void)bezier_blend(a, random_path(random, 2, 4, true), 0.5), InvalidArgument);
  std::vector<double> small(5);
  EXPECT_THROW(HermiteBlend(a, a).at(0.5, small), InvalidArgument);
}

}  // namespace
}  // namespace tandem
