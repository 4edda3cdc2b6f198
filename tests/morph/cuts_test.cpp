#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tandem/curve/nearest_point.h"
#include "tandem/morph/path_morph.h"
#include "tandem/morph/quality.h"
#include "tandem/shape/measures.h"
#include "tandem/shape/path_builder.h"

namespace tandem {
namespace {

// A solid against several: cut along inner chords.

Curve polygon(const std::vector<Vec2>& points) {
  PathBuilder builder;
  builder.move_to(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) builder.line_to(points[i]);
  builder.close();
  return to_curve(builder.take().front());
}

Curve box(double x, double y, double width, double height) {
  return polygon({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}

Shape play() {
  return {{polygon({{6, 4}, {20, 12}, {6, 20}})}};
}
Shape pause() {
  return {{box(5, 4, 5, 16), box(14, 4, 5, 16)}};
}
Shape plate(bool second_hole) {
  Shape shape{{box(0, 0, 20, 8), box(3, 3, 2, 2)}};
  if (second_hole) shape.contours.push_back(box(15, 3, 2, 2));
  shape.fill_rule = FillRule::evenodd;
  return shape;
}
Shape two_plates(bool second_hole) {
  Shape shape{{box(0, 0, 8, 8), box(12, 0, 8, 8), box(3, 3, 2, 2)}};
  if (second_hole) shape.contours.push_back(box(15, 3, 2, 2));
  shape.fill_rule = FillRule::evenodd;
  return shape;
}

std::vector<Vec2> points_of(const CubicPath& path) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < path.segment_count(); ++i) {
    const auto p = path.segment(i);
    for (int k = 0; k < 16; ++k) {
      const double t = k / 16.0;
      const double u = 1 - t;
      const auto at = [&](std::size_t c) {
        return u * u * u * p[0][c] + 3 * u * u * t * p[1][c] + 3 * u * t * t * p[2][c] + t * t * t * p[3][c];
      };
      points.push_back({at(0), at(1)});
    }
  }
  return points;
}

int winding(const std::vector<CubicPath>& paths, Vec2 p) {
  int sum = 0;
  for (const CubicPath& path : paths) {
    const std::vector<Vec2> q = points_of(path);
    for (std::size_t i = 0; i < q.size(); ++i) {
      const Vec2 a = q[i];
      const Vec2 b = q[(i + 1) % q.size()];
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) sum += b.y > a.y ? 1 : -1;
    }
  }
  return sum;
}

std::vector<CubicPath> paths_of(const Shape& shape) {
  std::vector<CubicPath> paths;
  for (const Curve& contour : shape.contours) paths.push_back(to_cubic_path(contour, 1e-6));
  return paths;
}

// Points of a fine grid that only one of the two fills: none when they fill the same.
std::size_t difference(const std::vector<CubicPath>& morphed, const Shape& shape) {
  const std::vector<CubicPath> paths = paths_of(shape);
  std::size_t count = 0;
  for (double x = -1.013; x < 25; x += 0.2) {
    for (double y = -1.017; y < 25; y += 0.2) {
      const int own = winding(paths, {x, y});
      const bool wanted = shape.fill_rule == FillRule::evenodd ? own % 2 != 0 : own != 0;
      if ((winding(morphed, {x, y}) != 0) != wanted) ++count;
    }
  }
  return count;
}

// How far the morph's contours stray from the shape's outlines: what a stroke would show.
double stray(const std::vector<CubicPath>& morphed, const Shape& shape) {
  double worst = 0.0;
  for (const CubicPath& path : morphed) {
    for (const Vec2 p : points_of(path)) {
      double nearest = 1e9;
      for (const Curve& contour : shape.contours) {
        nearest = std::min(nearest, nearest_point(contour, Point{p.x, p.y}).distance);
      }
      worst = std::max(worst, nearest);
    }
  }
  return worst;
}

double area(const std::vector<CubicPath>& paths) {
  double sum = 0.0;
  for (const CubicPath& path : paths) sum += signed_area(path);
  return std::fabs(sum);
}

PathMorph morph(const Shape& a, const Shape& b, bool cuts = true) {
  MorphOptions options;
  options.cuts = cuts;
  const std::vector<Shape> keys{a, b};
  return PathMorph(keys, options);
}

std::size_t whole_contours(const PathMorph& made) {
  const auto& contours = made.steps()[0].contours;
  return static_cast<std::size_t>(
      std::count_if(contours.begin(), contours.end(), [](const ContourStep& c) { return c.a && c.b; }));
}

void expect_exact_ends(const PathMorph& made, const Shape& a, const Shape& b) {
  EXPECT_EQ(difference(made.at(0), a), 0U);
  EXPECT_EQ(difference(made.at(1), b), 0U);
  EXPECT_LT(stray(made.at(0), a), 1e-4);
  EXPECT_LT(stray(made.at(1), b), 1e-4);
}

TEST(Cuts, OneBecomesTwo) {
  const PathMorph made = morph(play(), pause());
  ASSERT_EQ(made.contours().size(), 2U);
  for (const ContourStep& contour : made.steps()[0].contours) {
    EXPECT_EQ(contour.a, std::size_t{0});
    EXPECT_TRUE(contour.match);
  }
  EXPECT_NE(made.steps()[0].contours[0].b, made.steps()[0].contours[1].b);
  expect_exact_ends(made, play(), pause());
  EXPECT_EQ(measure_quality(made).faulty, 0U);
  // Nothing grows from a point: the pieces hold what the whole did.
  const double from = area(made.at(0));
  const double to = area(made.at(1));
  for (const double s : {0.25, 0.5, 0.75}) EXPECT_NEAR(area(made.at(s)), (1 - s) * from + s * to, 0.15 * from);
  for (const CubicPath& piece : made.at(0.5)) EXPECT_GT(signed_area(piece), 0.2 * to);
}

TEST(Cuts, TwoBecomeOneTheSameWay) {
  const PathMorph made = morph(pause(), play());
  ASSERT_EQ(made.contours().size(), 2U);
  for (const ContourStep& contour : made.steps()[0].contours) EXPECT_EQ(contour.b, std::size_t{0});
  expect_exact_ends(made, pause(), play());
  EXPECT_EQ(measure_quality(made).faulty, 0U);
}

TEST(Cuts, NothingJumpsAtTheEnds) {
  const PathMorph made = morph(play(), pause());
  EXPECT_LT(stray(made.at(2e-4), play()), 1e-3 * 21);
  EXPECT_LT(stray(made.at(1 - 2e-4), pause()), 1e-3 * 21);
  EXPECT_LT(measure_quality(made).step_ratio, 3.0);
}

TEST(Cuts, HolesGoToThePieceTheyLieIn) {
  const PathMorph made = morph(plate(false), two_plates(false));
  ASSERT_EQ(whole_contours(made), 3U);
  expect_exact_ends(made, plate(false), two_plates(false));
  EXPECT_EQ(measure_quality(made).faulty, 0U);
  for (const double s : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    EXPECT_EQ(winding(made.at(s), {4.1, 4.1}), 0) << s;
    EXPECT_EQ(winding(made.at(s), {6.1, 4.1}), 1) << s;
  }
}

TEST(Cuts, BetweenTwoHolesTheFillIsStillExact) {
  const PathMorph made = morph(plate(true), two_plates(true));
  EXPECT_EQ(difference(made.at(0), plate(true)), 0U);
  EXPECT_EQ(difference(made.at(1), two_plates(true)), 0U);
  for (const double s : {0.0, 0.5, 1.0}) {
    EXPECT_EQ(winding(made.at(s), {4.1, 4.1}), 0) << s;
    EXPECT_EQ(winding(made.at(s), {16.1, 4.1}), 0) << s;
  }
}

TEST(Cuts, AreLeftOutOnDemand) {
  const PathMorph made = morph(play(), pause(), false);
  EXPECT_EQ(whole_contours(made), 1U);
}

TEST(Cuts, OfMoreKeysThereAreNone) {
  const std::vector<Shape> keys{play(), pause(), play()};
  const PathMorph made(keys, {});
  for (const MorphStep& step : made.steps()) {
    std::vector<std::size_t> seen;
    for (const ContourStep& contour : step.contours) {
      if (contour.a) seen.push_back(*contour.a);
    }
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(std::adjacent_find(seen.begin(), seen.end()), seen.end());
  }
}

TEST(Cuts, IntoThree) {
  const Shape bar{{box(0, 8, 24, 6)}};
  const Shape dots{{box(0, 9, 4, 4), box(10, 9, 4, 4), box(20, 9, 4, 4)}};
  const PathMorph made = morph(bar, dots);
  ASSERT_EQ(whole_contours(made), 3U);
  expect_exact_ends(made, bar, dots);
  EXPECT_EQ(measure_quality(made).faulty, 0U);
}

}  // namespace
}  // namespace tandem
