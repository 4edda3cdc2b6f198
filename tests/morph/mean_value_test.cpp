#include "morph/mean_value.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tandem/shape/path_builder.h"
#include "tandem/shape/transform.h"

namespace tandem {
namespace {

using detail::carried_along;

CubicPath outline() {
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.line_to({6, 0});
  builder.cubic_to({9, 1}, {9, 5}, {6, 6});
  builder.line_to({0, 6});
  builder.line_to({3, 3});
  builder.close();
  return builder.take().front();
}

CubicPath mapped(const CubicPath& path, const Transform& map) {
  Points points = path.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 p = map({points[i][0], points[i][1]});
    points[i][0] = p.x;
    points[i][1] = p.y;
  }
  return CubicPath(std::move(points), path.is_closed());
}

// Mean value coordinates reproduce affine maps, inside and outside.
TEST(MeanValue, FollowsAffineMaps) {
  const Transform map =
      Transform::translate(3, -1) * Transform::rotate_degrees(35) * Transform::scale(2, 0.5);
  for (const Vec2 p : {Vec2{5, 3}, Vec2{4, 0.5}, Vec2{1, 0.5}, Vec2{0.5, 3}, Vec2{20, -7}, Vec2{-3, 3}}) {
    const Vec2 q = carried_along(p, outline(), mapped(outline(), map));
    EXPECT_NEAR(q.x, map(p).x, 1e-9);
    EXPECT_NEAR(q.y, map(p).y, 1e-9);
  }
}

TEST(MeanValue, VerticesAndEdgesGoWithTheOutline) {
  const CubicPath from = outline();
  const CubicPath to = mapped(outline(), Transform::scale(3, 2));
  const Vec2 vertex = carried_along({0, 6}, from, to);
  EXPECT_NEAR(vertex.x, 0, 1e-12);
  EXPECT_NEAR(vertex.y, 12, 1e-12);
  const Vec2 on_edge = carried_along({2, 0}, from, to);
  EXPECT_NEAR(on_edge.x, 6, 1e-9);
  EXPECT_NEAR(on_edge.y, 0, 1e-9);
}

TEST(MeanValue, AreContinuous) {
  const CubicPath from = outline();
  Points moved = from.control_points();
  moved[6][0] += 2;  // the middle of the bulge's end, and nothing else
  const CubicPath to(std::move(moved), true);
  const Vec2 a = carried_along({5, 3}, from, to);
  const Vec2 b = carried_along({5 + 1e-7, 3}, from, to);
  EXPECT_NEAR(a.x, b.x, 1e-6);
  EXPECT_GT(a.x, 5.0);
  EXPECT_LT(a.x, 7.0);
}

TEST(MeanValue, OfAPointIsThatPoint) {
  const CubicPath from = outline();
  const CubicPath point = mapped(from, Transform::translate(4, 4) * Transform::scale(0, 0));
  const Vec2 q = carried_along({5, 3}, from, point);
  EXPECT_NEAR(q.x, 4, 1e-12);
  EXPECT_NEAR(q.y, 4, 1e-12);
}

}  // namespace
}  // namespace tandem
