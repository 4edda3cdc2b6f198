#include "tandem/shape/path_builder.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tandem/error.h"

namespace tandem {
namespace {

Vec2 point(const CubicPath& path, std::size_t i) {
  return {path.control_points()[i][0], path.control_points()[i][1]};
}

Vec2 evaluate(const CubicPath& path, std::size_t segment, double t) {
  const double b[4] = {(1 - t) * (1 - t) * (1 - t), 3 * t * (1 - t) * (1 - t), 3 * t * t * (1 - t),
                       t * t * t};
  Vec2 p;
  for (std::size_t k = 0; k < 4; ++k) {
    p.x += b[k] * point(path, 3 * segment + k).x;
    p.y += b[k] * point(path, 3 * segment + k).y;
  }
  return p;
}

TEST(PathBuilder, DrawsWhatItIsTold) {
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.line_to({3, 0});
  builder.quad_to({3, 3}, {6, 3});
  builder.cubic_to({7, 3}, {8, 4}, {9, 9});
  const std::vector<CubicPath> paths = builder.take();
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_FALSE(paths[0].is_closed());
  const Points expected({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 2}, {4, 3}, {6, 3}, {7, 3}, {8, 4}, {9, 9}});
  ASSERT_EQ(paths[0].control_points().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(point(paths[0], i).x, expected[i][0], 1e-15) << i;
    EXPECT_NEAR(point(paths[0], i).y, expected[i][1], 1e-15) << i;
  }
  EXPECT_TRUE(paths[0].is_line(0, 0.0));
  EXPECT_FALSE(paths[0].is_line(1, 0.1));
}

TEST(PathBuilder, ClosesByALineWhenTheEndsAreApart) {
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.line_to({4, 0});
  builder.line_to({4, 3});
  builder.close();
  EXPECT_EQ(builder.current(), (Vec2{0, 0}));
  builder.line_to({0, 7});  // starts at the closed subpath's first point
  const std::vector<CubicPath> paths = builder.take();
  ASSERT_EQ(paths.size(), 2u);
  EXPECT_TRUE(paths[0].is_closed());
  EXPECT_EQ(paths[0].segment_count(), 3u);
  EXPECT_TRUE(paths[0].is_line(2, 1e-15));
  EXPECT_EQ(point(paths[1], 0), (Vec2{0, 0}));
  EXPECT_EQ(point(paths[1], 3), (Vec2{0, 7}));
}

TEST(PathBuilder, SnapsEndsThatMeetUpToRounding) {
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.line_to({4, 0});
  builder.line_to({4, 3});
  builder.line_to({1e-10, 0});
  builder.close();
  const std::vector<CubicPath> paths = builder.take();
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0].segment_count(), 3u);
  EXPECT_EQ(point(paths[0], 9), point(paths[0], 0));
  EXPECT_TRUE(paths[0].is_line(2, 1e-15));
}

TEST(PathBuilder, DropsALastSegmentThatLiesInTheGap) {
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.line_to({4, 0});
  builder.line_to({4, 3});
  builder.line_to({0, 0});
  builder.line_to({1e-10, 0});
  builder.close();
  const std::vector<CubicPath> paths = builder.take();
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0].segment_count(), 3u);
  EXPECT_EQ(point(paths[0], 9), point(paths[0], 0));
}

TEST(PathBuilder, LeavesOutWhatHasNoLength) {
  PathBuilder builder;
  builder.move_to({1, 1});
  builder.move_to({2, 2});
  builder.close();
  builder.line_to({2, 2});
  builder.cubic_to({2, 2}, {2, 2}, {2, 2});
  builder.quad_to({2, 2}, {2, 2});
  builder.arc_to({5, 5}, 0, true, true, {2, 2});
  builder.close();
  EXPECT_TRUE(builder.take().empty());

  builder.move_to({0, 0});
  builder.line_to({0, 0});
  builder.line_to({1, 0});
  builder.cubic_to({2, 1}, {0, 1}, {1, 0});  // a loop has length though its ends agree
  const std::vector<CubicPath> paths = builder.take();
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0].segment_count(), 2u);
}

TEST(PathBuilder, WantsACurrentPoint) {
  PathBuilder builder;
  EXPECT_FALSE(builder.has_current());
  EXPECT_THROW(builder.line_to({1, 1}), InvalidArgument);
  EXPECT_THROW(builder.arc_to({1, 1}, 0, false, false, {1, 1}), InvalidArgument);
  EXPECT_NO_THROW(builder.close());
}

TEST(PathBuilder, RejectsNumbersThatAreNotFinite) {
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.line_to({std::numeric_limits<double>::infinity(), 0});
  EXPECT_THROW((void)builder.take(), InvalidArgument);
  PathBuilder other;
  other.move_to({0, 0});
  other.arc_to({1, 1}, std::numeric_limits<double>::quiet_NaN(), false, false, {1, 1});
  EXPECT_NO_THROW((void)other.take());  // an arc that cannot be drawn is the line to its end
}

TEST(PathBuilder, SendsEverythingThroughTheTransform) {
  PathBuilder builder;
  builder.set_transform(Transform::translate(5, 5) * Transform::rotate_degrees(90));
  builder.move_to({1, 0});
  builder.line_to({4, 0});
  EXPECT_EQ(builder.current(), (Vec2{4, 0}));
  const std::vector<CubicPath> paths = builder.take();
  EXPECT_EQ(point(paths[0], 0), (Vec2{5, 6}));
  EXPECT_EQ(point(paths[0], 3), (Vec2{5, 9}));
}

// The unit circle in two arcs, as SVG readers draw it.
TEST(PathBuilder, CircleStaysWithin5e6OfItsRadius) {
  PathBuilder builder;
  builder.move_to({1, 0});
  builder.arc_to({1, 1}, 0, false, true, {-1, 0});
  builder.arc_to({1, 1}, 0, false, true, {1, 0});
  builder.close();
  const std::vector<CubicPath> paths = builder.take();
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0].segment_count(), 8u);
  double worst = 0.0;
  double turned = 0.0;
  Vec2 last{1, 0};
  for (std::size_t s = 0; s < paths[0].segment_count(); ++s) {
    for (int i = 1; i <= 32; ++i) {
      const Vec2 p = evaluate(paths[0], s, i / 32.0);
      worst = std::max(worst, std::fabs(std::sqrt(p.x * p.x + p.y * p.y) - 1.0));
      turned += std::atan2(last.x * p.y - last.y * p.x, last.x * p.x + last.y * p.y);
      last = p;
    }
  }
  EXPECT_LE(worst, 5e-6);
  EXPECT_NEAR(turned, 2 * std::numbers::pi, 1e-9);  // sweep: from x towards y
}

// Any arc, against the ellipse it was cut from: centre, radii, axis, start angle and sweep are chosen, the
// SVG form is worked out from them, and the cubics must follow the ellipse all the way round.
TEST(PathBuilder, ArcsFollowTheirEllipse) {
  EXPECT_TRUE(rc::check([] {
    const double rx = *rc::gen::inRange(1, 10000) / 100.0;
    const double ry = *rc::gen::inRange(1, 10000) / 100.0;
    const double axis = *rc::gen::inRange(-1000, 1000) / 2.0;
    const Vec2 center{*rc::gen::inRange(-100, 100) / 1.0, *rc::gen::inRange(-100, 100) / 1.0};
    const double start = *rc::gen::inRange(-314, 314) / 100.0;
    const double sweep = *rc::gen::inRange(1, 620) / 100.0 * (*rc::gen::arbitrary<bool>() ? 1 : -1);
    // At half a turn the flag is decided by rounding.
    RC_PRE(std::fabs(std::fabs(sweep) - std::numbers::pi) > 1e-3);
    const double phi = axis * std::numbers::pi / 180.0;
    const auto on_ellipse = [&](double angle) {
      const double x = rx * std::cos(angle);
      const double y = ry * std::sin(angle);
      return Vec2{center.x + std::cos(phi) * x - std::sin(phi) * y,
                  center.y + std::sin(phi) * x + std::cos(phi) * y};
    };
    PathBuilder builder;
    builder.move_to(on_ellipse(start));
    builder.arc_to({rx, ry}, axis, std::fabs(sweep) > std::numbers::pi, sweep > 0, on_ellipse(start + sweep));
    const std::vector<CubicPath> paths = builder.take();
    RC_ASSERT(paths.size() == 1u);
    const auto k = paths[0].segment_count();
    RC_ASSERT(std::fabs(sweep) / static_cast<double>(k) <= std::numbers::pi / 4 + 1e-6);
    for (std::size_t s = 0; s < k; ++s) {
      for (double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const Vec2 p = evaluate(paths[0], s, t);
        const double x = std::cos(phi) * (p.x - center.x) + std::sin(phi) * (p.y - center.y);
        const double y = std::cos(phi) * (p.y - center.y) - std::sin(phi) * (p.x - center.x);
        RC_ASSERT(std::fabs(std::sqrt(x / rx * (x / rx) + y / ry * (y / ry)) - 1.0) <= 5e-6);
      }
      // Joints stand at equal angles.
      const Vec2 joint = evaluate(paths[0], s, 1.0);
      const Vec2 want = on_ellipse(start + sweep * static_cast<double>(s + 1) / static_cast<double>(k));
      RC_ASSERT(std::fabs(joint.x - want.x) + std::fabs(joint.y - want.y) <= 1e-7 * (rx + ry));
    }
  }));
}

TEST(PathBuilder, ArcRadiiTooSmallGrowUntilTheyReach) {
  PathBuilder builder;
  builder.move_to({-2, 0});
  builder.arc_to({1, 0.5}, 0, false, true, {2, 0});  // becomes half of the ellipse with radii 2 and 1
  const std::vector<CubicPath> paths = builder.take();
  const std::size_t k = paths[0].segment_count();
  EXPECT_EQ(k, 4u);
  const Vec2 top = evaluate(paths[0], k / 2 - 1, 1.0);
  EXPECT_NEAR(top.x, 0.0, 1e-15);
  EXPECT_NEAR(top.y, -1.0, 1e-15);
}

TEST(PathBuilder, ArcsOfZeroRadiusAreLines) {
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.arc_to({0, 5}, 30, true, false, {3, 3});
  builder.arc_to({-5, 5}, 0, false, true, {13, 3});  // the sign of a radius does not count
  const std::vector<CubicPath> paths = builder.take();
  EXPECT_TRUE(paths[0].is_line(0, 0.0));
  EXPECT_EQ(paths[0].segment_count(), 5u);
}

TEST(PathBuilder, ArcsSurviveHugeAndTinyNumbers) {
  EXPECT_TRUE(rc::check([] {
    const auto any = [] {
      const int exponent = *rc::gen::inRange(-300, 300);
      return *rc::gen::inRange(-9, 10) * std::pow(10.0, exponent);
    };
    const Vec2 from{any(), any()};
    const Vec2 to{any(), any()};
    PathBuilder builder;
    builder.move_to(from);
    builder.arc_to({any(), any()}, any(), *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(), to);
    try {
      const std::vector<CubicPath> paths = builder.take();
      if (from == to) {
        RC_ASSERT(paths.empty());
      } else {
        RC_ASSERT(paths.size() == 1u);
        RC_ASSERT(point(paths[0], 0) == from);
        RC_ASSERT(point(paths[0], paths[0].control_points().size() - 1) == to);
      }
    } catch (const InvalidArgument&) {
      // An ellipse grown beyond the range of a double is said to be so, not drawn.
    }
  }));
}

TEST(PathBuilder, ArcOfHugeRadiusIsNearlyItsChord) {
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.arc_to({1e12, 1e12}, 0, false, true, {1, 0});
  const std::vector<CubicPath> paths = builder.take();
  ASSERT_EQ(paths[0].segment_count(), 1u);
  EXPECT_TRUE(paths[0].is_line(0, 1e-12));
}

}  // namespace
}  // namespace tandem
