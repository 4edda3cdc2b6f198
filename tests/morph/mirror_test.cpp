#include "morph/mirror.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tandem/curve/nearest_point.h"
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

// How far the mirror image about x = 12 is from the outline.
double off_axis(const Curve& outline) {
  double most = 0.0;
  for (int k = 0; k < 256; ++k) {
    Point p = outline.evaluate(outline.domain().lo + outline.domain().length() * k / 256.0);
    p[0] = 24.0 - p[0];
    most = std::max(most, nearest_point(outline, p).distance);
  }
  return most;
}

// A bell with a knob becomes a heart, and the heart a shield: lopsided ways have smoother tangents.
TEST(Mirror, SymmetryCountsMoreThanTangents) {
  PathBuilder builder;
  builder.move_to({21, 19});
  builder.line_to({21, 20});
  builder.line_to({3, 20});
  builder.line_to({3, 19});
  builder.line_to({5, 17});
  builder.line_to({5, 11});
  builder.cubic_to({5, 7.9}, {7.03, 5.17}, {10, 4.29});
  builder.cubic_to({9.6, 1.3}, {14.4, 1.3}, {14, 4.29});
  builder.cubic_to({16.97, 5.17}, {19, 7.9}, {19, 11});
  builder.line_to({19, 17});
  builder.close();
  const Curve bell = to_curve(builder.take().front());
  builder.move_to({12, 1});
  builder.line_to({3, 5});
  builder.line_to({3, 11});
  builder.cubic_to({3, 16.55}, {6.84, 21.74}, {12, 23});
  builder.cubic_to({17.16, 21.74}, {21, 16.55}, {21, 11});
  builder.line_to({21, 5});
  builder.close();
  const Curve shield = to_curve(builder.take().front());
  builder.move_to({12, 21.35});
  builder.line_to({10.55, 20.03});
  builder.cubic_to({5.4, 15.36}, {2, 12.27}, {2, 8.5});
  builder.cubic_to({2, 5.41}, {4.42, 3}, {7.5, 3});
  builder.cubic_to({9.24, 3}, {10.91, 3.81}, {12, 5.08});
  builder.cubic_to({13.09, 3.81}, {14.76, 3}, {16.5, 3});
  builder.cubic_to({19.58, 3}, {22, 5.41}, {22, 8.5});
  builder.cubic_to({22, 12.27}, {18.6, 15.36}, {13.45, 20.03});
  builder.close();
  const Curve flat_heart = to_curve(builder.take().front());
  for (const Curve& other : {bell, shield}) {
    const PathMorph made(std::vector<Shape>{{{flat_heart}}, {{other}}}, {});
    for (const double s : {0.25, 0.5, 0.75}) EXPECT_LE(off_axis(to_curve(made.at(s)[0])), 0.2) << s;
  }
}

// The curve of a match that was mirrored is the second outline along the mirrored correspondence.
TEST(Mirror, TheWholeMatchIsMirrored) {
  const PathMorph made(std::vector<Shape>{{{heart()}}, {{star(5)}}}, {});
  const Match& match = *made.steps()[0].contours[0].match;
  const Curve second = star(5);
  const Interval domain = second.domain();
  double most = 0.0;
  for (int k = 0; k < 64; ++k) {
    const double u = match.curve.domain().lo + match.curve.domain().length() * (k + 0.5) / 64.0;
    double v = match.correspondence.v_at(u);
    v -= std::floor((v - domain.lo) / domain.length()) * domain.length();
    const Point p = match.curve.evaluate(u);
    const Point q = second.evaluate(v);
    most = std::max(most, std::hypot(p[0] - q[0], p[1] - q[1]));
  }
  EXPECT_LE(most, 0.1);  // the tolerance of the fit, of a length of 80
}

}  // namespace
}  // namespace tandem
