#include "morph/mirror.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "tandem/morph/path_morph.h"
#include "tandem/shape/path_builder.h"

namespace tandem {
namespace {

using detail::find_mirrors;
using detail::Mirror;
using detail::Reflection;

Curve polygon(const std::vector<Vec2>& points) {
  PathBuilder builder;
  builder.move_to(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) builder.line_to(points[i]);
  builder.close();
  return to_curve(builder.take().front());
}

// Clockwise as seen with y downwards.
Curve heart() {
  PathBuilder builder;
  builder.move_to({12, 6});
  builder.cubic_to({13, 4}, {15, 3}, {17, 3});
  builder.cubic_to({20, 3}, {22, 5}, {22, 8});
  builder.cubic_to({22, 13}, {17, 17}, {12, 21});
  builder.cubic_to({7, 17}, {2, 13}, {2, 8});
  builder.cubic_to({2, 5}, {4, 3}, {7, 3});
  builder.cubic_to({9, 3}, {11, 4}, {12, 6});
  builder.close();
  return to_curve(builder.take().front());
}

Curve star(int points) {
  std::vector<Vec2> corners;
  for (int i = 0; i < 2 * points; ++i) {
    const double angle = 3.14159265358979323846 * (static_cast<double>(i) / points - 0.5);
    const double radius = i % 2 == 0 ? 10.0 : 4.0;
    corners.push_back({12 + radius * std::cos(angle), 12 + radius * std::sin(angle)});
  }
  return polygon(corners);
}

TEST(Mirror, AxesOfWhatHasSome) {
  EXPECT_EQ(find_mirrors(polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}})).size(), 4U);
  EXPECT_EQ(find_mirrors(polygon({{0, 0}, {7, 0}, {7, 3}, {0, 3}})).size(), 2U);
  EXPECT_EQ(find_mirrors(star(5)).size(), 5U);
  const std::vector<Mirror> found = find_mirrors(heart());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(std::remainder(found[0].degrees - 90.0, 180.0), 0.0, 1e-6);
  const std::vector<double> ends{found[0].u, found[0].opposite};
  EXPECT_TRUE((ends == std::vector<double>{0, 3}) || (ends == std::vector<double>{3, 0}));
}

TEST(Mirror, NoneOfWhatHasNone) {
  EXPECT_TRUE(find_mirrors(polygon({{0, 0}, {9, 0}, {3, 5}})).empty());
  EXPECT_TRUE(find_mirrors(polygon({{0, 0}, {6, 0}, {8, 3}, {2, 3}})).empty());  // a turn only
  EXPECT_TRUE(find_mirrors(polygon({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 5}})).empty());
}

TEST(Mirror, SharedAxesFollowTheTurn) {
  const std::vector<Mirror> a = find_mirrors(heart());
  const std::vector<Mirror> b = find_mirrors(polygon({{0, 0}, {8, 4}, {0, 8}}));  // points along x
  EXPECT_FALSE(shared_mirror(a, b, 0.0));
  EXPECT_TRUE(shared_mirror(a, b, 90.0));
  EXPECT_TRUE(shared_mirror(a, b, -90.0));
}

TEST(Mirror, AHeartBecomesAStarUpright) {
  const PathMorph made(std::vector<Shape>{{{heart()}}, {{star(5)}}}, {});
  for (const double s : {0.25, 0.5, 0.75}) {
    const std::vector<CubicPath> paths = made.at(s);
    ASSERT_EQ(paths.size(), 1U);
    EXPECT_EQ(find_mirrors(to_curve(paths[0])).size(), 1U) << s;
  }
}

}  // namespace
}  // namespace tandem
