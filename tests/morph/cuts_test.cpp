#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "morph/cut_keys.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/curve/nearest_point.h"
#include "tandem/morph/path_morph.h"
#include "tandem/morph/quality.h"
#include "tandem/shape/measures.h"
#include "tandem/shape/nesting.h"
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

using Polygons = std::vector<std::vector<Vec2>>;

Polygons flattened(const std::vector<CubicPath>& paths) {
  Polygons polygons;
  for (const CubicPath& path : paths) polygons.push_back(points_of(path));
  return polygons;
}

int winding(const Polygons& polygons, Vec2 p) {
  int sum = 0;
  for (const std::vector<Vec2>& q : polygons) {
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
  const Polygons paths = flattened(paths_of(shape));
  const Polygons own = flattened(morphed);
  std::size_t count = 0;
  for (double x = -1.013; x < 25; x += 0.3) {
    for (double y = -1.017; y < 25; y += 0.3) {
      const int turns = winding(paths, {x, y});
      const bool wanted = shape.fill_rule == FillRule::evenodd ? turns % 2 != 0 : turns != 0;
      if ((winding(own, {x, y}) != 0) != wanted) ++count;
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
  for (const double s : {0.25, 0.5, 0.75})
    EXPECT_NEAR(area(made.at(s)), (1 - s) * from + s * to, 0.15 * from);
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
    EXPECT_EQ(winding(flattened(made.at(s)), {4.1, 4.1}), 0) << s;
    EXPECT_EQ(winding(flattened(made.at(s)), {6.1, 4.1}), 1) << s;
  }
}

// The chord has nowhere to come in from: there is no cut.
TEST(Cuts, NoneBetweenTwoHoles) {
  const PathMorph made = morph(plate(true), two_plates(true));
  EXPECT_EQ(difference(made.at(0), plate(true)), 0U);
  EXPECT_EQ(difference(made.at(1), two_plates(true)), 0U);
  EXPECT_LT(whole_contours(made), 4U);
}

TEST(Cuts, WhatIsBornGrowsEvenlyInEveryBlend) {
  const auto circle = [](double x, double radius) {
    PathBuilder builder;
    builder.move_to({x + radius, 10});
    builder.arc_to({radius, radius}, 0, false, true, {x - radius, 10});
    builder.arc_to({radius, radius}, 0, false, true, {x + radius, 10});
    builder.close();
    return to_curve(builder.take().front());
  };
  const std::vector<Shape> keys{{{circle(5, 4)}}, {{circle(5, 4), circle(18, 2)}}};
  for (const BlendKind kind : {BlendKind::affine, BlendKind::hermite, BlendKind::intrinsic}) {
    MorphOptions options;
    options.cuts = false;
    options.blend = kind;
    const PathMorph made(keys, options);
    ASSERT_EQ(made.contours().size(), 2U);
    const double whole = signed_area(made.at(1)[1]);
    for (const double s : {0.1, 0.5, 0.8}) {
      EXPECT_NEAR(signed_area(made.at(s)[1]), s * s * whole, 1e-9 * std::fabs(whole));
    }
    EXPECT_LT(measure_quality(made).g1_defect, 1e-7);
  }
}

// Drawn with round caps, a stroke of no length is a dot: another stroke covers it.
TEST(Cuts, StrokesGrowOutOfStrokes) {
  const auto line = [](Vec2 a, Vec2 b) {
    PathBuilder builder;
    builder.move_to(a);
    builder.line_to(b);
    return to_curve(builder.take().front());
  };
  const Shape plus{{line({12, 4}, {12, 20}), line({4, 12}, {20, 12})}};
  const Shape minus{{line({4, 15}, {20, 15})}};
  for (const bool grows : {true, false}) {
    const PathMorph made = grows ? morph(minus, plus) : morph(plus, minus);
    EXPECT_LT(stray(made.at(grows ? 0 : 1), minus), 1e-6);
    EXPECT_LT(stray(made.at(grows ? 1 : 0), plus), 1e-6);
  }
}

TEST(Cuts, OpenContoursAreClosedOnDemand) {
  const auto square = [](double x, double size, bool inside) {
    PathBuilder builder;
    builder.move_to({x, x});
    builder.line_to(inside ? Vec2{x, x + size} : Vec2{x + size, x});
    builder.line_to({x + size, x + size});
    builder.line_to(inside ? Vec2{x + size, x} : Vec2{x, x + size});
    return to_curve(builder.take().front());
  };
  const std::vector<Shape> keys{{{square(0, 10, false), square(3, 4, true)}},
                                {{square(1, 10, false), square(4, 5, true)}}};
  for (const CubicPath& path : PathMorph(keys, {}).at(0.5)) EXPECT_FALSE(path.is_closed());
  MorphOptions options;
  options.match.closed = ClosedMode::yes;
  const PathMorph made(keys, options);
  for (const CubicPath& path : made.at(0.5)) EXPECT_TRUE(path.is_closed());
  EXPECT_NEAR(area(made.at(0)), 100 - 16, 1e-9);  // a hole is a hole again
  EXPECT_NEAR(area(made.at(1)), 100 - 25, 1e-9);
}

// An open contour against a closed one, which is cut open where that is best.
TEST(Cuts, AClosedContourBecomesAnOpenOne) {
  PathBuilder builder;  // three sides of a square, and a square that starts in the middle of the fourth
  builder.move_to({10, 0});
  builder.line_to({0, 0});
  builder.line_to({0, 10});
  builder.line_to({10, 10});
  const Shape open{{to_curve(builder.take().front())}};
  const Shape closed{{polygon({{5, 10}, {0, 10}, {0, 0}, {10, 0}, {10, 10}})}};
  const PathMorph made = morph(closed, open);
  ASSERT_EQ(made.contours().size(), 1U);
  for (const double s : {0.0, 0.5, 1.0}) EXPECT_FALSE(made.at(s)[0].is_closed());
  EXPECT_LT(stray(made.at(0), closed), 1e-6);
  EXPECT_LT(stray(made.at(1), open), 1e-6);
  EXPECT_EQ(measure_quality(made).faulty, 0U);
  const Points first = made.at(0)[0].control_points();
  EXPECT_NEAR(first[0][0], 10.0, 1.6);  // the cut is in the side that the open one lacks, or beside it
}

TEST(Cuts, TheReportCountsContoursThatDrawNothing) {
  Shape a = play();
  a.contours.insert(a.contours.begin(), Curve(1, {0, 0, 1, 1}, Points{{1, 1}, {1, 1}}));
  const PathMorph made = morph(a, pause());
  for (const ContourStep& contour : made.steps()[0].contours) EXPECT_EQ(contour.a, std::size_t{1});
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

// The pieces that a contour is cut into for two others.
std::vector<detail::KeyPart> cut_for(const Curve& whole, const Curve& first, const Curve& second) {
  const std::vector<CubicPath> a{to_cubic_path(whole, 1e-6)};
  const std::vector<CubicPath> b{to_cubic_path(first, 1e-6), to_cubic_path(second, 1e-6)};
  const detail::ContourPair pairs[] = {{0, 0, 0.0}, {{}, 1, 0.0}};
  const auto cut = detail::cut_keys(a, b, pairs, Rotation(2));
  return cut ? cut->a : std::vector<detail::KeyPart>{};
}

// A strip becomes two bars beside each other: a short chord across it would leave one above the other.
TEST(Cuts, PiecesLieWhereTheyBelongThoughChordsAreLonger) {
  const std::vector<detail::KeyPart> cut = cut_for(box(0, 0, 8, 40), box(0, 0, 5, 8), box(6, 0, 5, 8));
  ASSERT_EQ(cut.size(), 2U);
  EXPECT_NEAR(bounding_box(to_curve(cut[0].path)).hi[0], 4.0, 0.5);
  EXPECT_NEAR(bounding_box(to_curve(cut[1].path)).lo[0], 4.0, 0.5);
}

// A third and two thirds stay so, though their centres are those of halves.
TEST(Cuts, PiecesKeepTheirAreasThoughTheyLieElsewhere) {
  const std::vector<detail::KeyPart> cut = cut_for(box(0, 0, 20, 8), box(0, 2.5, 10, 3), box(10, 0.5, 10, 7));
  ASSERT_EQ(cut.size(), 2U);
  EXPECT_NEAR(signed_area(cut[0].path), 48.0, 8.0);
  EXPECT_NEAR(signed_area(cut[1].path), 112.0, 8.0);
}

// Three pieces, two of them with holes, of which one chord ends on the other: it has nowhere to be pushed.
TEST(Cuts, NoneThatShowsAChordFromTheStart) {
  const std::vector<CubicPath> plate{to_cubic_path(box(0, 0, 18, 20), 1e-6),
                                     to_cubic_path(box(4, 3, 1, 2), 1e-6),
                                     to_cubic_path(box(13, 3, 1, 2), 1e-6)};
  const std::vector<CubicPath> three{to_cubic_path(box(0, 0, 8, 9), 1e-6),
                                     to_cubic_path(box(10, 0, 8, 9), 1e-6),
                                     to_cubic_path(box(0, 11, 18, 9), 1e-6)};
  const std::vector<CubicPath> wound = orient(plate, FillRule::evenodd);
  const detail::ContourPair pairs[] = {{0, 0, 0.0}, {1, {}, 0.0}, {2, {}, 0.0}, {{}, 1, 0.0}, {{}, 2, 0.0}};
  const auto cut = detail::cut_keys(wound, three, pairs, Rotation(2));
  EXPECT_FALSE(cut && cut->a.size() > 3);
  // Without holes there is.
  const detail::ContourPair alone[] = {{0, 0, 0.0}, {{}, 1, 0.0}, {{}, 2, 0.0}};
  const auto whole = detail::cut_keys(std::span(wound).first(1), three, alone, Rotation(2));
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->a.size(), 3U);
}

}  // namespace
}  // namespace tandem
