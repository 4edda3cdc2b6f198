#include "tandem/morph/quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "morph/test_shapes.h"
#include "tandem/error.h"

namespace tandem {
namespace {

CubicPath polygon(const std::vector<Vec2>& points) {
  PathBuilder builder;
  builder.move_to(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) builder.line_to(points[i]);
  builder.close();
  return builder.take().front();
}

CubicPath rectangle(double x, double y, double width, double height) {
  return polygon({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}

TEST(MorphQuality, OfASlidingShapeIsPerfect) {
  const MorphQuality quality =
      measure_quality(Motion([](double s) { return std::vector{rectangle(7 * s, -3 * s, 4, 2)}; }));
  EXPECT_EQ(quality.in_betweens, 20u);
  EXPECT_EQ(quality.faulty, 0u);
  EXPECT_EQ(quality.faulty_keys, 0u);
  EXPECT_FALSE(quality.first.has_value());
  EXPECT_EQ(quality.g1_defect, 0.0);
  EXPECT_NEAR(quality.length_deviation, 0.0, 1e-14);
  EXPECT_NEAR(quality.area_deviation, 0.0, 1e-14);
  EXPECT_NEAR(quality.step_ratio, 1.0, 1e-12);
  EXPECT_TRUE(quality.complete);
}

// A vertex at height 2 - 12 s (1 - s), below the base for s (1 - s) > 1/6.
std::vector<CubicPath> dipping(double s) {
  return {polygon({{0, 0}, {4, 0}, {4, 4}, {2, 2 - 12 * s * (1 - s)}, {0, 4}})};
}

TEST(MorphQuality, CountsInBetweensThatCrossThemselves) {
  const MorphQuality quality = measure_quality(Motion(dipping));
  std::size_t expected = 0;
  for (int i = 1; i <= 20; ++i) expected += i * (21 - i) * 6 > 21 * 21 ? 1u : 0u;
  EXPECT_EQ(expected, 12u);
  EXPECT_EQ(quality.crossing, expected);
  EXPECT_EQ(quality.crossing_between, 0u);
  EXPECT_EQ(quality.faulty, expected);
  EXPECT_EQ(quality.faulty_keys, 0u);
  ASSERT_TRUE(quality.first.has_value());
  EXPECT_EQ(quality.first->fault, MorphFault::crossing);
  EXPECT_NEAR(quality.first->s, 5.0 / 21.0, 1e-15);
  ASSERT_TRUE(quality.first->point.has_value());
  EXPECT_NEAR(quality.first->point->y, 0.0, 1e-12);
  // Where the line from (4, 4) to the vertex, or its mirror image, comes down to 0.
  const double depth = 12 * (5.0 / 21.0) * (16.0 / 21.0) - 2;
  EXPECT_NEAR(std::fabs(quality.first->point->x - 2), 2 * depth / (4 + depth), 1e-9);
}

TEST(MorphQuality, EndsWhenThereAreMoreFaultsThanAllowed) {
  const MorphQuality ended = measure_quality(Motion(dipping), {.most_faulty = 2});
  EXPECT_FALSE(ended.complete);
  EXPECT_EQ(ended.faulty, 3u);
  EXPECT_EQ(ended.in_betweens, 3u);  // those in the middle came first
  const MorphQuality whole = measure_quality(Motion(dipping), {.most_faulty = 12});
  EXPECT_TRUE(whole.complete);
  EXPECT_EQ(whole.in_betweens, 20u);
}

TEST(MorphQuality, CountsContoursThatCrossEachOther) {
  // The small square moves out over the right edge of the large one.
  const auto motion = [](double s) {
    return std::vector{rectangle(0, 0, 4, 4), rectangle(1 + 8 * s, 1, 1, 1)};
  };
  const MorphQuality quality = measure_quality(Motion(motion));
  std::size_t across = 0;
  std::size_t inside = 0;
  for (int i = 1; i <= 20; ++i) {
    const double left = 1 + 8 * i / 21.0;
    across += left < 4 && left + 1 > 4 ? 1u : 0u;
    inside += left + 1 < 4 ? 1u : 0u;
  }
  EXPECT_EQ(quality.crossing_between, across);
  EXPECT_EQ(quality.crossing, 0u);
  EXPECT_EQ(quality.folded, inside + across);  // 1/16 of the area, or what is left of it
  EXPECT_EQ(quality.faulty_keys, 1u);
  EXPECT_EQ(quality.first->fault, MorphFault::fold);
  EXPECT_FALSE(quality.first->point.has_value());
}

TEST(MorphQuality, FoldsCountFromTheBoundOn) {
  const Motion motion = [](double) { return std::vector{rectangle(0, 0, 10, 10), rectangle(4, 4, 1, 1)}; };
  EXPECT_EQ(measure_quality(motion, {.largest_fold = 0.02}).folded, 0u);
  EXPECT_EQ(measure_quality(motion, {.largest_fold = 0.005}).folded, 20u);
}

TEST(MorphQuality, G1DefectIsWhatSmoothJointsLose) {
  // Two cubics with a joint at (0, 0) that turns by `angle`, and corners elsewhere.
  const auto bent = [](double angle) {
    PathBuilder builder;
    builder.move_to({-3, -3});
    builder.cubic_to({-3, -1}, {-1, 0}, {0, 0});
    builder.cubic_to({2 * std::cos(angle), 2 * std::sin(angle)}, {3, -1}, {3, -3});
    builder.close();
    return std::vector{builder.take().front()};
  };
  const auto measured = [&](double at_keys, double between) {
    return measure_quality(Motion([&](double s) { return bent(s == 0.0 || s == 1.0 ? at_keys : between); }))
        .g1_defect;
  };
  EXPECT_NEAR(measured(0.0, 0.3), 0.3, 1e-9);
  EXPECT_NEAR(measured(0.0, 1e-7), 1e-7, 1e-12);
  EXPECT_NEAR(measured(0.01, 0.3), 0.29, 1e-9);
  EXPECT_EQ(measured(0.3, 0.01), 0.0);
  EXPECT_EQ(measured(0.1, 0.3), 0.0);  // a corner
  EXPECT_EQ(measured(0.0, 0.0), 0.0);
}

// A rectangle turned by 90 degrees through linear blends: at the middle it has shrunk by sqrt(1/2).
TEST(MorphQuality, LengthAndAreaAreComparedWithTheBlendOfTheKeys) {
  const auto turned = [](double s) {
    const CubicPath a = polygon({{-2, -1}, {2, -1}, {2, 1}, {-2, 1}});
    Points points = a.control_points();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double x = points[i][0];
      const double y = points[i][1];
      points[i][0] = (1 - s) * x - s * y;
      points[i][1] = (1 - s) * y + s * x;
    }
    return std::vector{CubicPath(std::move(points), true)};
  };
  const MorphQuality quality = measure_quality(Motion(turned), {.in_betweens = 19});
  EXPECT_NEAR(quality.length_deviation, 1 - std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(quality.area_deviation, 0.5, 1e-12);
  // A circle that grows from radius 1 to 3 has the blend's length, and less than the blend's area: 4 pi,
  // not 5.
  const auto growing = [](double s) {
    PathBuilder builder;
    const double r = 1 + 2 * s;
    builder.move_to({r, 0});
    builder.arc_to({r, r}, 0, false, true, {-r, 0});
    builder.arc_to({r, r}, 0, false, true, {r, 0});
    builder.close();
    return builder.take();
  };
  const MorphQuality growth = measure_quality(Motion(growing), {.in_betweens = 3});
  EXPECT_NEAR(growth.length_deviation, 0.0, 1e-12);
  EXPECT_NEAR(growth.area_deviation, 0.25, 1e-12);  // at s = 1/4: 2.25 to 3; at 1/2: 4 to 5
}

TEST(MorphQuality, StepsAreComparedWithTheirMean) {
  const auto sliding = [](auto place) {
    return Motion([place](double s) { return std::vector{rectangle(place(s), 0, 1, 1)}; });
  };
  EXPECT_NEAR(measure_quality(sliding([](double s) { return s * s; })).step_ratio,
              21 * (1 - std::pow(20.0 / 21, 2)), 1e-9);
  EXPECT_NEAR(measure_quality(sliding([](double s) { return s < 0.5 ? 0.0 : 1.0; })).step_ratio, 21.0, 1e-9);
  EXPECT_EQ(measure_quality(sliding([](double) { return 3.0; })).step_ratio, 1.0);
  // Evenly between keys, at different speeds.
  const auto keyed = sliding([](double s) { return s < 0.5 ? s : 10 * s - 4.5; });
  EXPECT_NEAR(measure_quality(keyed, {.key_count = 3}).step_ratio, 1.0, 1e-9);
}

TEST(MorphQuality, OfPathMorphsIsThatOfTheirInBetweens) {
  MorphOptions options;
  options.match.samples = {32, 32};
  const std::vector<Shape> keys{test::one(test::blob(3, 0)), test::one(test::blob(5, 4)),
                                test::one(test::blob(2, 0))};
  const PathMorph morph(keys, options);
  const MorphQuality quality = measure_quality(morph);
  EXPECT_EQ(quality.in_betweens, 40u);
  EXPECT_EQ(quality.faulty, 0u);
  EXPECT_GT(quality.length_deviation, 0.0);
  EXPECT_LT(quality.length_deviation, 0.2);
  const MorphQuality same = measure_quality(Motion([&](double s) { return morph.at(s); }), {.key_count = 3});
  EXPECT_EQ(quality.length_deviation, same.length_deviation);
  EXPECT_EQ(quality.area_deviation, same.area_deviation);
  EXPECT_EQ(quality.g1_defect, same.g1_defect);
}

TEST(MorphQuality, RefusesWhatIsNoMorph) {
  const Motion square = [](double) { return std::vector{rectangle(0, 0, 1, 1)}; };
  EXPECT_THROW((void)measure_quality(square, {.key_count = 1}), InvalidArgument);
  EXPECT_THROW((void)measure_quality(square, {.in_betweens = 0}), InvalidArgument);
  EXPECT_THROW((void)measure_quality(square, {.largest_fold = -1}), InvalidArgument);
  EXPECT_THROW((void)measure_quality(square, {.smooth_angle = std::numeric_limits<double>::quiet_NaN()}),
               InvalidArgument);
  const Motion changing = [](double s) {
    return std::vector{s < 0.5 ? rectangle(0, 0, 1, 1) : polygon({{0, 0}, {1, 0}, {0, 1}})};
  };
  EXPECT_THROW((void)measure_quality(changing), InvalidArgument);
  const Motion multiplying = [](double s) {
    return std::vector<CubicPath>(s < 0.5 ? 1 : 2, rectangle(0, 0, 1, 1));
  };
  EXPECT_THROW((void)measure_quality(multiplying), InvalidArgument);
}

}  // namespace
}  // namespace tandem
