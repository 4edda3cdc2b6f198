#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "match/cubic_paths.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/match/match.h"
#include "tandem/match/rotation.h"
#include "tandem/match/segments.h"

// match() with Method::segments.

namespace tandem {
namespace {

using cubics::backwards;
using cubics::from_joint;
using cubics::random_path;

double distance(const Point& p, const Point& q) {
  double sum = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) sum += (p[k] - q[k]) * (p[k] - q[k]);
  return std::sqrt(sum);
}

/// A point of the curve, of a loop also beyond its ends.
Point at(const Curve& curve, double t) {
  const Interval domain = curve.domain();
  if (curve.is_closed()) t -= std::floor((t - domain.lo) / domain.length()) * domain.length();
  return curve.evaluate(domain.clamp(t));
}

/// The match's curve runs with the second one as the correspondence says, and the joints meet.
void expect_in_step(const Curve& a, const Curve& b, const Match& match) {
  const std::vector<ParameterPair>& points = match.correspondence.points;
  const Interval domain = match.curve.domain();
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    for (const double t : {0.0, 0.4}) {
      double u = (1 - t) * points[k].u + t * points[k + 1].u;
      const double v = (1 - t) * points[k].v + t * points[k + 1].v;
      if (match.correspondence.closed) u -= std::floor((u - domain.lo) / domain.length()) * domain.length();
      EXPECT_LT(distance(match.curve.evaluate(domain.clamp(u)), at(b, v)), 1e-8);
    }
  }
  EXPECT_EQ(match.correspondence.closed, a.is_closed() && b.is_closed());
}

TEST(SegmentsMethod, BringsCurvesInStepAsTheSegmentsAre) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 40; ++trial) {
    const CubicPath a = random_path(random, 2 + trial % 2, 1 + random() % 6, trial % 4 < 2);
    const CubicPath b = random_path(random, 2 + trial % 2, 1 + random() % 6, trial % 2 == 0);
    const SegmentMatch segments = match_segments(a, b);
    const Match found = match(to_curve(a), to_curve(b), {.method = Method::segments});
    EXPECT_EQ(found.report.method, Method::segments);
    EXPECT_EQ(found.report.cost, segments.cost);
    EXPECT_EQ(found.report.path, segments.path);
    EXPECT_EQ(found.report.direction, segments.direction);
    EXPECT_EQ(found.correspondence.points, segments.correspondence.points);
    // Slopes of v are limited.
    bool steep = false;
    for (std::size_t k = 1; k < found.correspondence.points.size(); ++k) {
      const ParameterPair p = found.correspondence.points[k - 1];
      const ParameterPair q = found.correspondence.points[k];
      const double slope = std::fabs(q.v - p.v) / (q.u - p.u);
      steep = steep || !(slope > 2e-3 && slope < 500.0);
    }
    if (!steep) expect_in_step(to_curve(a), to_curve(b), found);
  }
}

TEST(SegmentsMethod, KnowsLoopsFromAnyStartInAnyDirection) {
  std::mt19937 random(2);
  const CubicPath a = random_path(random, 2, 6, true);
  const Match found = match(to_curve(a), to_curve(backwards(from_joint(a, 4))), {.method = Method::segments});
  EXPECT_EQ(found.report.cost, 0.0);
  EXPECT_EQ(found.report.direction, Direction::reversed);
  EXPECT_EQ(found.report.samples, (std::array<int, 2>{6, 6}));
  EXPECT_TRUE(found.report.validity.valid);
  EXPECT_NEAR(found.report.validity.min_dot, 1.0, 1e-9);
}

TEST(SegmentsMethod, TakesOtherCurvesAsCubics) {
  // A rational circle over [3, 7], and a quintic.
  const double h = std::sqrt(0.5);
  const Curve circle(2, {3, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 7},
                     Points({{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}),
                     {1, h, 1, h, 1, h, 1, h, 1});
  const Match found = match(circle, circle, {.method = Method::segments});
  EXPECT_EQ(found.correspondence.domain_u, circle.domain());
  EXPECT_NEAR(found.report.cost, 0.0, 1e-20);
  expect_in_step(circle, circle, found);
  const Curve quintic =
      Curve::clamped_uniform(5, Points({{0, 0}, {1, 2}, {2, -1}, {3, 3}, {4, 0}, {5, 1}, {6, 6}, {8, 0}}));
  const Curve lifted = with_domain(elevate_degree(quintic), {-2, 5});
  const Match other = match(quintic, lifted, {.method = Method::segments});
  EXPECT_NEAR(other.report.cost, 0.0, 1e-9);
  for (double u = 0.0; u <= 1.0; u += 0.05) {
    EXPECT_LT(distance(other.curve.evaluate(u), quintic.evaluate(u)), 1e-4);
  }
}

TEST(SegmentsMethod, MatchesUnderATurn) {
  std::mt19937 random(3);
  const CubicPath a = random_path(random, 2, 5, true);
  const double x = std::cos(2.0);
  const double y = std::sin(2.0);
  const Rotation turn(2, std::vector<double>{x, y});
  const Curve b = to_curve(CubicPath(turn(a.control_points()), true));
  const Match given = match(to_curve(a), b, {.method = Method::segments, .rotation = {x, y}});
  EXPECT_NEAR(given.report.cost, 0.0, 1e-25);
  const Match found = match(to_curve(a), b, {.method = Method::segments, .rotate = true});
  EXPECT_NEAR(found.report.cost, 0.0, 1e-8);
  EXPECT_NEAR(found.report.rotation[0], x, 1e-6);
  EXPECT_NEAR(found.report.validity.min_dot, 1.0, 1e-6);
}

TEST(SegmentsMethod, CanBeCancelled) {
  std::mt19937 random(4);
  const Curve a = to_curve(random_path(random, 2, 5, true));
  const Match found = match(a, a, {.method = Method::segments, .progress = [](double) { return false; }});
  EXPECT_TRUE(found.report.cancelled);
}

TEST(SegmentsMethod, HasNoPinnedForm) {
  std::mt19937 random(5);
  const Curve a = to_curve(random_path(random, 2, 5, true));
  EXPECT_THROW((void)match(a, a, {.method = Method::segments, .closed = ClosedMode::pinned}),
               InvalidArgument);
}

}  // namespace
}  // namespace tandem
