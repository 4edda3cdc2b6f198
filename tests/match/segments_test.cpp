#include "tandem/match/segments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>
#include <vector>

#include "match/cubic_paths.h"
#include "match/plain_segments.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using cubics::backwards;
using cubics::from_joint;
using cubics::largest_difference;
using cubics::moved;
using cubics::random_path;

/// What every match must be: exact subdivisions of the inputs, joined by arcs whose costs add up.
void expect_sound(const CubicPath& a, const CubicPath& b, const SegmentMatch& match,
                  const SegmentOptions& options) {
  ASSERT_EQ(match.a.segment_count(), match.b.segment_count());
  ASSERT_EQ(match.pieces_a.size(), match.a.segment_count());
  ASSERT_EQ(match.correspondence.points.size(), match.a.segment_count() + 1);
  const CubicPath run = match.direction == Direction::reversed ? backwards(b) : b;
  double cost = 0.0;
  for (std::size_t k = 1; k < match.path.size(); ++k) {
    const Node from = match.path[k - 1];
    const Node to = match.path[k];
    ASSERT_TRUE((to.i - from.i == 1 && to.j > from.j) || (to.j - from.j == 1 && to.i > from.i));
    cost += plain::node_to_node(a, run, from, to, options);
  }
  EXPECT_NEAR(match.cost, cost, 1e-9 * std::max(1.0, cost));
  const Curve curve_a = to_curve(a);
  const Curve curve_b = to_curve(b);
  const auto wrapped = [](double t, const CubicPath& path) {
    const auto n = static_cast<double>(path.segment_count());
    return path.is_closed() ? t - n * std::floor(t / n) : std::clamp(t, 0.0, n);
  };
  for (std::size_t k = 0; k < match.a.segment_count(); ++k) {
    for (const double t : {0.0, 0.3, 0.5, 0.9}) {
      const auto& [u0, v0] = match.correspondence.points[k];
      const auto& [u1, v1] = match.correspondence.points[k + 1];
      ASSERT_LE(u0, u1);
      const Point p = to_curve(match.a).evaluate(static_cast<double>(k) + t);
      const Point q = to_curve(match.b).evaluate(static_cast<double>(k) + t);
      const Point wanted_p = curve_a.evaluate(wrapped((1 - t) * u0 + t * u1, a));
      const Point wanted_q = curve_b.evaluate(wrapped((1 - t) * v0 + t * v1, b));
      const SegmentPiece& piece = match.pieces_b[k];
      const Point origin_q =
          curve_b.evaluate(static_cast<double>(piece.segment) + (1 - t) * piece.from + t * piece.to);
      for (std::size_t d = 0; d < p.size(); ++d) {
        EXPECT_NEAR(p[d], wanted_p[d], 1e-9);
        EXPECT_NEAR(q[d], wanted_q[d], 1e-9);
        EXPECT_NEAR(q[d], origin_q[d], 1e-9);
      }
    }
  }
}

using Case = std::tuple<bool, bool, SegmentSplit, SegmentCost>;

class EverySegmentPath : public testing::TestWithParam<Case> {};

TEST_P(EverySegmentPath, CostsNoLessThanTheBest) {
  const auto [closed_a, closed_b, split, cost] = GetParam();
  std::mt19937 random(7);
  for (int trial = 0; trial < 24; ++trial) {
    const std::size_t m = 1 + random() % 4;
    const std::size_t n = 1 + random() % 5;
    const int dim = 2 + static_cast<int>(random() % 2);
    const CubicPath a = random_path(random, dim, m, closed_a);
    const CubicPath b = random_path(random, dim, n, closed_b);
    SegmentOptions options{.split = split, .cost = cost};
    const double forward = plain::best(a, b, options);
    const double backward = plain::best(a, backwards(b), options);
    const SegmentMatch match = match_segments(a, b, options);
    EXPECT_NEAR(match.cost, std::min(forward, backward), 1e-9 * match.cost) << m << " against " << n;
    if (std::fabs(forward - backward) > 1e-9 * forward) {
      EXPECT_EQ(match.direction == Direction::reversed, backward < forward);
    }
    expect_sound(a, b, match, options);
    options.direction = Direction::reversed;
    EXPECT_NEAR(match_segments(a, b, options).cost, backward, 1e-9 * backward);
  }
}

INSTANTIATE_TEST_SUITE_P(Segments, EverySegmentPath,
                         testing::Combine(testing::Bool(), testing::Bool(),
                                          testing::Values(SegmentSplit::proportional, SegmentSplit::uniform),
                                          testing::Values(SegmentCost::derivative, SegmentCost::paper)));

TEST(Segments, LimitTheirRuns) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const CubicPath a = random_path(random, 2, 3, trial % 2 == 0);
    const CubicPath b = random_path(random, 2, 5, trial % 2 == 0);
    SegmentOptions options{.longest_run = 2, .direction = Direction::forward};
    const SegmentMatch match = match_segments(a, b, options);
    EXPECT_NEAR(match.cost, plain::best(a, b, options), 1e-9 * match.cost);
    options.longest_run = 1;
    EXPECT_THROW((void)match_segments(a, b, options), InvalidArgument);
  }
}

/// The same curve, every segment divided where it is told.
CubicPath divided(const CubicPath& path, double at) {
  Points points;
  points.push_back(path.control_points()[0]);
  for (std::size_t i = 0; i < path.segment_count(); ++i) {
    const auto [left, right] = plain::halves(plain::segment(path, static_cast<int>(i)), at);
    for (const auto& half : {left, right}) {
      for (std::size_t k = 1; k < 4; ++k) points.push_back(half[k]);
    }
  }
  return CubicPath(std::move(points), path.is_closed());
}

TEST(Segments, CostInDerivativesDoesNotChangeWhenBothAreSubdivided) {
  std::mt19937 random(4);
  const CubicPath a = random_path(random, 2, 1, false);
  const CubicPath b = random_path(random, 2, 1, false);
  const double whole = match_segments(a, b, {.direction = Direction::forward}).cost;
  const plain::Cubic p = plain::segment(a, 0);
  const plain::Cubic q = plain::segment(b, 0);
  EXPECT_NEAR(whole, plain::derivative_cost(p, q, 1.0), 1e-12 * whole);
  const auto [p0, p1] = plain::halves(p, 0.3);
  const auto [q0, q1] = plain::halves(q, 0.3);
  EXPECT_NEAR(whole, plain::derivative_cost(p0, q0, 0.3) + plain::derivative_cost(p1, q1, 0.7),
              1e-12 * whole);
  // The paper's sum does.
  EXPECT_GT(std::fabs(plain::paper_cost(p, q) - plain::paper_cost(p0, q0) - plain::paper_cost(p1, q1)),
            0.1 * plain::paper_cost(p, q));
}

/// Spec D5: a line against the same line in pieces of other lengths.
TEST(Segments, CostNothingAgainstTheirPartsWhenSplitByLength) {
  const CubicPath line(Points({{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
  const CubicPath parts = divided(line, 0.25);
  EXPECT_NEAR(match_segments(line, parts).cost, 0.0, 1e-14);
  EXPECT_NEAR(match_segments(line, parts, {.cost = SegmentCost::paper}).cost, 0.0, 1e-14);
  EXPECT_GT(match_segments(line, parts, {.split = SegmentSplit::uniform}).cost, 0.01);
}

// The four criteria of [D] section 1, as far as the matching is concerned (spec D7).

TEST(Segments, PreserveIdentity) {
  std::mt19937 random(5);
  for (const bool closed : {false, true}) {
    const CubicPath a = random_path(random, 3, 7, closed);
    const SegmentMatch match = match_segments(a, a);
    EXPECT_EQ(match.cost, 0.0);
    EXPECT_EQ(match.a, a);
    EXPECT_EQ(match.b, a);
  }
}

TEST(Segments, DoNotSeeTranslations) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 10; ++trial) {
    const CubicPath a = random_path(random, 2, 6, true);
    const CubicPath b = random_path(random, 2, 9, true);
    const SegmentMatch here = match_segments(a, b);
    const SegmentMatch there = match_segments(a, moved(b, 4.0));
    EXPECT_NEAR(here.cost, there.cost, 1e-9 * here.cost);
    EXPECT_EQ(here.path, there.path);
    const SegmentMatch copy = match_segments(a, moved(a, 4.0));
    EXPECT_NEAR(copy.cost, 0.0, 1e-12);
    EXPECT_LT(largest_difference(copy.b, moved(copy.a, 4.0)), 1e-13);
  }
}

TEST(Segments, FindTheSameLoopFromAnyStartInAnyDirection) {
  std::mt19937 random(8);
  const CubicPath a = random_path(random, 2, 9, true);
  for (std::size_t first = 0; first < 9; ++first) {
    const SegmentMatch match = match_segments(a, from_joint(a, first));
    EXPECT_EQ(match.cost, 0.0);
    EXPECT_EQ(match.b, a);
    EXPECT_EQ(match.shift, static_cast<int>((9 - first) % 9));
    const SegmentMatch back = match_segments(a, backwards(from_joint(a, first)));
    EXPECT_EQ(back.direction, Direction::reversed);
    EXPECT_EQ(back.b, a);
  }
}

TEST(Segments, AreTheSameFromBothSides) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 40; ++trial) {
    const CubicPath a = random_path(random, 2, 1 + random() % 8, trial % 4 < 2);
    const CubicPath b = random_path(random, 2, 1 + random() % 8, trial % 2 == 0);
    const SegmentMatch one = match_segments(a, b);
    const SegmentMatch other = match_segments(b, a);
    EXPECT_EQ(one.cost, other.cost);
    EXPECT_EQ(one.direction, other.direction);
    ASSERT_EQ(one.a.segment_count(), other.a.segment_count());
    const Correspondence back = other.correspondence.inverse();
    // A loop that was cut may be a lap further on.
    const double m = static_cast<double>(a.segment_count());
    const double n = static_cast<double>(b.segment_count());
    const double laps_u = std::round((back.domain_u.lo - one.correspondence.domain_u.lo) / m) * m;
    for (double share = 0.05; share < 1.0; share += 0.1) {
      const double u = one.correspondence.domain_u.lo + share * m;
      const double gap = one.correspondence.v_at(u) - back.v_at(u + laps_u);
      EXPECT_NEAR(b.is_closed() ? std::remainder(gap, n) : gap, 0.0, 1e-9);
    }
  }
}

TEST(Segments, DoNotDependOnWhereLoopsStart) {
  std::mt19937 random(10);
  for (int trial = 0; trial < 20; ++trial) {
    const CubicPath a = random_path(random, 2, 5, true);
    const CubicPath b = random_path(random, 2, 8, true);
    const SegmentMatch match = match_segments(a, b);
    const SegmentMatch moved_start = match_segments(from_joint(a, 2), from_joint(b, 3));
    EXPECT_EQ(match.cost, moved_start.cost);
    ASSERT_EQ(match.a.segment_count(), moved_start.a.segment_count());
    const auto same = [&](const SegmentPiece& x, const SegmentPiece& y) {
      return (x.segment + 3) % 5 == y.segment && x.from == y.from && x.to == y.to;
    };
    std::vector<SegmentPiece> pieces = match.pieces_a;
    const auto start = std::find_if(pieces.begin(), pieces.end(), [](const SegmentPiece& piece) {
      return piece.segment == 2 && piece.from == 0.0;
    });
    std::rotate(pieces.begin(), start, pieces.end());
    EXPECT_TRUE(std::equal(pieces.begin(), pieces.end(), moved_start.pieces_a.begin(), same));
  }
}

TEST(Segments, AcceptHugeAndTinyCoordinatesAndPoints) {
  std::mt19937 random(11);
  const CubicPath a = random_path(random, 2, 3, true);
  const CubicPath b = random_path(random, 2, 4, true);
  const SegmentMatch match = match_segments(a, b);
  for (const double factor : {0x1p-900, 0x1p900}) {
    const auto scaled = [&](const CubicPath& path) {
      Points points = path.control_points();
      for (double& x : points.data()) x *= factor;
      return CubicPath(std::move(points), true);
    };
    EXPECT_EQ(match_segments(scaled(a), scaled(b)).path, match.path);
  }
  const CubicPath point(Points({{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}}), true);
  const SegmentMatch dying = match_segments(a, point);
  EXPECT_EQ(dying.a.segment_count(), dying.b.segment_count());
  for (double x : dying.b.control_points().data()) EXPECT_EQ(x, 1.0);
}

TEST(Segments, CanBeCancelled) {
  std::mt19937 random(12);
  const CubicPath a = random_path(random, 2, 8, true);
  const CubicPath b = random_path(random, 2, 9, true);
  int calls = 0;
  const SegmentMatch match = match_segments(a, b, {.progress = [&](double fraction) {
                                              EXPECT_GE(fraction, 0.0);
                                              EXPECT_LE(fraction, 1.0);
                                              return ++calls < 2;
                                            }});
  EXPECT_TRUE(match.cancelled);
  EXPECT_EQ(calls, 2);
}

TEST(Segments, SayWhatIsWrong) {
  const CubicPath flat(Points({{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
  const CubicPath deep(Points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}));
  EXPECT_THROW((void)match_segments(flat, deep), InvalidArgument);
  EXPECT_THROW((void)match_segments(flat, flat, {.longest_run = -1}), InvalidArgument);
  EXPECT_THROW((void)match_segments(flat, flat, {.closed = ClosedMode::yes}), InvalidArgument);
  EXPECT_THROW((void)match_segments(flat, flat, {.closed = ClosedMode::pinned}), InvalidArgument);
}

}  // namespace
}  // namespace tandem
