#include "morph/contour_pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "morph/drawing_mirror.h"
#include "tandem/shape/path_builder.h"

namespace tandem {
namespace {

using detail::ContourPair;
using detail::find_drawing_mirrors;
using detail::pair_contours;

using Drawing = std::vector<CubicPath>;

CubicPath polyline(const std::vector<Vec2>& points, bool close = false) {
  PathBuilder builder;
  builder.move_to(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) builder.line_to(points[i]);
  if (close) builder.close();
  return builder.take().front();
}

CubicPath line(Vec2 p, Vec2 q) {
  return polyline({p, q});
}

CubicPath box(double x, double y, double width, double height) {
  return polyline({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, true);
}

Drawing bars(const std::vector<double>& heights) {
  Drawing all;
  for (const double y : heights) all.push_back(line({0, y}, {18, y}));
  return all;
}

Drawing cross() {
  return {line({3, 0}, {15, 12}), line({15, 0}, {3, 12})};
}

// Of each contour of a: its partner, -1 for none.
std::vector<int> partners(const Drawing& a, const Drawing& b, double degrees = 0.0) {
  const double radians = degrees * 3.14159265358979323846 / 180.0;
  const double values[] = {std::cos(radians), std::sin(radians)};
  std::vector<int> found(a.size(), -1);
  for (const ContourPair& pair : pair_contours(a, b, Rotation(2, values), {}).pairs) {
    if (pair.a && pair.b) found[*pair.a] = static_cast<int>(*pair.b);
  }
  return found;
}

std::size_t mirror_count(const Drawing& drawing) {
  return find_drawing_mirrors(drawing).size();
}

TEST(DrawingMirror, AxesOfWhatHasSome) {
  EXPECT_EQ(mirror_count(bars({0, 6, 12})), 2U);
  EXPECT_EQ(mirror_count(cross()), 4U);
  EXPECT_EQ(mirror_count({box(0, 0, 4, 4), box(6, 0, 4, 4), box(0, 6, 4, 4), box(6, 6, 4, 4)}), 4U);
  EXPECT_EQ(mirror_count({box(0, 0, 10, 10), box(3, 3, 4, 4)}), 4U);
  EXPECT_EQ(mirror_count({box(0, 0, 10, 10), box(3, 1, 4, 4)}), 1U);
  EXPECT_EQ(mirror_count({polyline({{5, 0}, {0, 5}, {5, 10}}), line({0, 5}, {12, 5})}), 1U);
}

TEST(DrawingMirror, NoneOfWhatHasNone) {
  EXPECT_EQ(mirror_count({line({0, 0}, {18, 0}), line({0, 6}, {12, 6})}), 0U);
  EXPECT_EQ(mirror_count({box(0, 0, 4, 4), box(6, 3, 4, 4)}), 0U);  // a half turn only
  EXPECT_EQ(mirror_count({CubicPath(Points(2, 4))}), 0U);
}

TEST(DrawingMirror, SaysWhoIsWhoseImage) {
  for (const auto& mirror : find_drawing_mirrors(bars({0, 6, 12}))) {
    const bool level = std::fabs(std::remainder(mirror.degrees, 180.0)) < 1e-6;
    EXPECT_EQ(mirror.images,
              level ? (std::vector<std::size_t>{2, 1, 0}) : (std::vector<std::size_t>{0, 1, 2}));
  }
}

// The bar in the middle lies where the strokes of the cross do, and would be paired for less.
TEST(ContourPairs, TheOuterOnesOfThreeBarsBecomeACross) {
  for (const double height : {10.0, 12.0, 14.0, 18.0}) {
    const std::vector<int> found = partners(bars({0, height / 2, height}), cross());
    EXPECT_NE(found[0], -1) << height;
    EXPECT_EQ(found[1], -1) << height;
    EXPECT_NE(found[2], -1) << height;
    EXPECT_NE(found[0], found[2]) << height;
  }
  EXPECT_EQ(partners(bars({6, 0, 12}), cross())[0], -1);
}

TEST(ContourPairs, SoTheyDoTheOtherWayAndTurned) {
  const std::vector<int> back = partners(cross(), bars({0, 6, 12}));
  EXPECT_EQ(back[0] + back[1], 2);  // 0 and 2
  Drawing upright;
  for (const double x : {0.0, 6.0, 12.0}) upright.push_back(line({x, 0}, {x, 18}));
  EXPECT_EQ(partners(upright, cross())[1], -1);
  // Bars seen askew have no axis in common with the cross but when they are turned back.
  Drawing askew;
  for (const double d : {0.0, 6.0, 12.0}) {
    askew.push_back(line({-0.5 * d, 0.866025403784 * d}, {15.588457268 - 0.5 * d, 9 + 0.866025403784 * d}));
  }
  EXPECT_EQ(partners(bars({0, 6, 12}), askew, 30.0), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(partners(askew, cross(), -30.0)[1], -1);
}

TEST(ContourPairs, OfFilledBarsToo) {
  const Drawing three{box(0, 0, 18, 2), box(0, 5, 18, 2), box(0, 10, 18, 2)};
  const Drawing two{polyline({{3, 1}, {4, 0}, {15, 11}, {14, 12}}, true),
                    polyline({{14, 0}, {15, 1}, {4, 12}, {3, 11}}, true)};
  EXPECT_EQ(mirror_count(two), 4U);
  EXPECT_EQ(partners(three, two)[1], -1);
}

// The holes of two that are each other's mirror images are so, too.
TEST(ContourPairs, MirrorImagesTakeTheirHolesAlong) {
  const auto ring = [](double x, double y, double size) {
    return Drawing{box(x, y, size, size), box(x + 1, y + 1, size - 2, size - 2)};
  };
  Drawing a;
  for (const double x : {0.0, 6.0, 12.0}) {
    for (const CubicPath& path : ring(x, 0, 5)) a.push_back(path);
  }
  Drawing b;
  for (const double x : {4.0, 8.0}) {
    for (const CubicPath& path : ring(x, 0, 3.5)) b.push_back(path);
  }
  EXPECT_EQ(partners(a, b), (std::vector<int>{0, 1, -1, -1, 2, 3}));
}

// A tip and a shaft are no mirror images of each other: who keeps the axis would leave two bars and the tip
// alone.
TEST(ContourPairs, SymmetryLeavesNobodyAlone) {
  const Drawing arrow{polyline({{7, 0}, {0, 6}, {7, 12}}), line({0, 6}, {18, 6})};
  const std::vector<int> found = partners(bars({0, 6, 12}), arrow);
  EXPECT_EQ(
      static_cast<int>(found[0] == -1) + static_cast<int>(found[1] == -1) + static_cast<int>(found[2] == -1),
      1);
}

// Nor is it worth making a comb out of a line where there is a comb.
TEST(ContourPairs, SymmetryIsNotWorthEverything) {
  const auto comb = [](double y) {
    std::vector<Vec2> points;
    for (int i = -3; i <= 3; ++i) points.push_back({i % 2 == 0 ? 18.0 : 0.0, y + 0.5 * i});
    return polyline(points);
  };
  const std::vector<int> found =
      partners({line({0, 0}, {18, 0}), comb(6), line({0, 12}, {18, 12})}, {comb(4), comb(8)});
  EXPECT_NE(found[1], -1);
}

}  // namespace
}  // namespace tandem
