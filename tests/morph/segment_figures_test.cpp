#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "match/cubic_paths.h"
#include "tandem/match/segments.h"
#include "tandem/morph/segment_blend.h"

// What the figures of [D] show, on curves of our own (docs/segments.md draws these and others).

namespace tandem {
namespace {

/// A path of cubics, from its control points.
CubicPath path(std::vector<double> coordinates, bool closed = false) {
  return CubicPath(Points(2, std::move(coordinates)), closed);
}

CubicPath polygon(const std::vector<std::pair<double, double>>& corners) {
  Points points;
  for (std::size_t i = 0; i <= corners.size(); ++i) {
    const auto [x, y] = corners[i % corners.size()];
    if (i > 0) {
      const auto [x0, y0] = corners[i - 1];
      points.push_back(Point{x0 + (x - x0) / 3, y0 + (y - y0) / 3});
      points.push_back(Point{x + (x0 - x) / 3, y + (y0 - y) / 3});
    }
    points.push_back(Point{x, y});
  }
  return CubicPath(std::move(points), true);
}

TEST(SegmentFigures, Figure2OneSegmentMeetsThree) {
  const CubicPath a = path({0,  0,   10, -20, 20, -20, 30, 0,  35, 5, 40,  5,   45,  0,   55,  -20,
                            65, -20, 75, 0,   80, 30,  90, 30, 95, 0, 105, -10, 115, -10, 125, 0});
  const CubicPath b =
      path({0, 0, 15, -30, 60, -30, 75, 0, 80, 35, 95, 35, 100, 0, 110, -10, 120, -10, 130, 0});
  const SegmentMatch match = match_segments(a, b, {.direction = Direction::forward});
  EXPECT_EQ(match.path, (std::vector<Node>{{0, 0}, {3, 1}, {4, 2}, {5, 3}}));
  EXPECT_EQ(match.a, a);
  EXPECT_EQ(match.b.segment_count(), 5u);
  EXPECT_EQ(match.pieces_b[1].segment, 0u);
  EXPECT_EQ(match.pieces_b[3], (SegmentPiece{1, 0.0, 1.0}));
}

double shortest_edge(const CubicPath& p) {
  double least = INFINITY;
  for (std::size_t i = 0; i < p.segment_count(); ++i) {
    const auto [p0, p1, p2, p3] = p.segment(i);
    least = std::min(least, std::hypot(p3[0] - p0[0], p3[1] - p0[1]));
  }
  return least;
}

TEST(SegmentFigures, Figure4EdgesOfPolygonsAreSplitAndNotLost) {
  const CubicPath gable =
      polygon({{0, 60}, {30, 60}, {30, 20}, {50, 0}, {70, 20}, {70, 60}, {100, 60}, {100, 100}, {0, 100}});
  const CubicPath box =
      polygon({{0, 40}, {60, 40}, {60, 10}, {90, 10}, {90, 40}, {110, 40}, {110, 90}, {0, 90}});
  const SegmentMatch match = match_segments(gable, box);
  ASSERT_EQ(match.a.segment_count(), 9u);
  EXPECT_EQ(match.a, gable);
  // Matched by vertices, one of the box's nine edges would be a point.
  EXPECT_NEAR(shortest_edge(match.b), 15.0, 1e-12);
  const HermiteBlend blend(match.a, match.b);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_TRUE(blend.is_straight(i));
  // The cost of two lines is the squared difference of the edges, or a third of it.
  const CubicPath line = path({0, 0, 1, 0, 2, 0, 3, 0});
  const CubicPath other = path({5, 5, 6, 7, 7, 9, 8, 11});
  EXPECT_NEAR(match_segments(line, other).cost, 36.0, 1e-12);
  EXPECT_NEAR(match_segments(line, other, {.cost = SegmentCost::paper}).cost, 12.0, 1e-12);
}

TEST(SegmentFigures, Figure5FeaturesFindEachOther) {
  // Two fish; the tail's three corners and the mouth must stay what they are.
  const CubicPath plain = path(
      {0,   50, 20,  20, 60,  10, 90,  30, 100, 36, 108, 42, 115, 48, 123, 40, 132, 33, 140, 25, 136, 42,
       136, 58, 140, 75, 132, 68, 123, 61, 115, 54, 105, 70, 60,  95, 25,  72, 14,  65, 6,   58, 0,   50},
      true);
  const CubicPath finned =
      path({5,   40, 14,  26,  26,  18,  40,  14,  46, 4,   56, 0,   66, 2,   62, 8,   62, 12,  64, 16,  80,
            22,  92, 32,  100, 44,  106, 34,  114, 28, 124, 26, 118, 36, 116, 44, 116, 52, 118, 60, 122, 68,
            128, 74, 116, 74,  106, 68,  100, 60,  86, 76,  64, 84,  42, 78,  26, 74,  12, 60,  5,  40},
           true);
  const SegmentMatch match = match_segments(plain, cubics::from_joint(finned, 5));
  EXPECT_EQ(match.direction, Direction::forward);
  const auto joint_of = [&](std::size_t j) {
    // The point of the finned fish that belongs to joint j of the plain one.
    for (std::size_t k = 0; k < match.a.segment_count(); ++k) {
      if (match.pieces_a[k].segment == j && match.pieces_a[k].from == 0.0) {
        const auto p = match.b.control_points()[3 * k];
        return std::pair(p[0], p[1]);
      }
    }
    return std::pair<double, double>(NAN, NAN);
  };
  EXPECT_EQ(joint_of(0), std::pair(5.0, 40.0));    // mouth
  EXPECT_EQ(joint_of(2), std::pair(100.0, 44.0));  // before the tail
  EXPECT_EQ(joint_of(3), std::pair(124.0, 26.0));  // its tips
  EXPECT_EQ(joint_of(4), std::pair(128.0, 74.0));
  EXPECT_EQ(joint_of(5), std::pair(100.0, 60.0));
}

}  // namespace
}  // namespace tandem
