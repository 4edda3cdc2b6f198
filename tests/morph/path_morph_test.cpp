#include "tandem/morph/path_morph.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "morph/test_shapes.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/nearest_point.h"
#include "tandem/error.h"
#include "tandem/morph/align.h"
#include "tandem/shape/intersections.h"
#include "tandem/shape/measures.h"
#include "tandem/shape/path_builder.h"

namespace tandem {
namespace {

using test::any_outline;
using test::blob;
using test::distance;
using test::one;
using test::points_along;

// Few nodes: what is tested here does not depend on how good the match is.
MorphOptions quick() {
  MorphOptions options;
  options.match.samples = {24, 24};
  return options;
}

MorphOptions unturned() {
  MorphOptions options = quick();
  options.match.rotate = false;
  return options;
}

Curve square(double size) {
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.line_to({size, 0});
  builder.line_to({size, size});
  builder.line_to({0, size});
  builder.close();
  return to_curve(builder.take().front());
}

MorphOptions with(BlendKind blend) {
  MorphOptions options = unturned();
  options.blend = blend;
  return options;
}

constexpr BlendKind kKinds[] = {BlendKind::automatic, BlendKind::affine,     BlendKind::bezier,
                                BlendKind::hermite,   BlendKind::similarity, BlendKind::intrinsic,
                                BlendKind::detour};

std::vector<CubicPath> parse(const std::string& commands) {
  // M, H, V and Z with single numbers.
  PathBuilder builder;
  std::istringstream in(commands);
  Vec2 at;
  char letter = 0;
  while (in >> letter) {
    if (letter == 'M') {
      in >> at.x >> at.y;
      builder.move_to(at);
    } else if (letter == 'Z') {
      builder.close();
    } else {
      in >> (letter == 'H' ? at.x : at.y);
      builder.line_to(at);
    }
  }
  return builder.take();
}

// Whatever the blend, the ends are the keys.
TEST(PathMorph, RedrawsTheKeys) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Shape> keys{one(any_outline()), one(any_outline())};
    const PathMorph morph(
        keys, with(*rc::gen::elementOf(std::vector<BlendKind>(std::begin(kKinds), std::end(kKinds)))));
    for (std::size_t key = 0; key < 2; ++key) {
      const std::vector<CubicPath> paths = morph.at(static_cast<double>(key));
      RC_ASSERT(paths.size() == 1u);
      RC_ASSERT(paths[0].is_closed());
      const Curve drawn = to_curve(paths[0]);
      RC_ASSERT(distance(points_along(drawn, 40), keys[key].contours[0]) <= 1e-11);
      RC_ASSERT(distance(points_along(keys[key].contours[0], 40), drawn) <= 1e-11);
    }
  }));
}

// Beside a key there is no jump, and beyond it nothing explodes.
TEST(PathMorph, MovesSteadily) {
  const std::vector<Shape> keys{one(blob(3, 0)), one(square(9)), one(blob(5, 2))};
  for (const BlendKind kind : kKinds) {
    const PathMorph morph(keys, with(kind));
    std::vector<CubicPath> before = morph.at(-0.2);
    for (int k = -199; k <= 1200; ++k) {
      const std::vector<CubicPath> now = morph.at(k / 1000.0);
      const auto p = before[0].control_points().data();
      const auto q = now[0].control_points().data();
      for (std::size_t i = 0; i < p.size(); ++i) {
        EXPECT_LT(std::fabs(p[i] - q[i]), 0.15) << k << " blend " << static_cast<int>(kind);
      }
      before = now;
    }
  }
}

TEST(PathMorph, KeepsTheStructureAndBlendsPoints) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Shape> keys{one(any_outline()), one(any_outline()), one(any_outline())};
    const PathMorph morph(keys, with(BlendKind::affine));
    RC_ASSERT(morph.is_linear());
    const double s = *rc::gen::inRange(-50, 150) / 100.0;
    const CubicPath path = morph.at(s)[0];
    const PathContour& contour = morph.contours()[0];
    RC_ASSERT(path.segment_count() == contour.lines.size());
    const auto [key, local] = locate_key(s, 3);
    const auto a = contour.keys[key].control_points().data();
    const auto b = contour.keys[key + 1].control_points().data();
    for (std::size_t i = 0; i < a.size(); ++i) {
      RC_ASSERT(std::fabs(path.control_points().data()[i] - ((1 - local) * a[i] + local * b[i])) <= 1e-12);
    }
    // A segment written as a line is one in the in-between, too.
    for (std::size_t k = 0; k < path.segment_count(); ++k) {
      if (contour.lines[k]) RC_ASSERT(path.is_line(k, 1e-6));
    }
  }));
}

TEST(PathMorph, LinesStayLines) {
  const std::vector<Shape> keys{one(square(10)), one(square(4))};
  const PathMorph morph(keys, quick());
  for (const bool line : morph.contours()[0].lines) EXPECT_TRUE(line);
  const std::vector<Shape> mixed{one(square(10)), one(blob(4, 5))};
  const PathMorph other(mixed, with(BlendKind::affine));
  for (const bool line : other.contours()[0].lines) EXPECT_FALSE(line);
}

TEST(PathMorph, ApproximatesWhatIsNoCubic) {
  const double w = std::sqrt(0.5);
  // The unit circle as a rational quadratic.
  const Curve circle(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
                     Points({{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}),
                     {1, w, 1, w, 1, w, 1, w, 1});
  const std::vector<Shape> keys{one(circle), one(square(3))};
  std::size_t segments = 0;
  for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
    const PathMorph paths(keys, {}, tolerance);
    const double allowed = tolerance * paths.box().diagonal();
    const CubicPath path = paths.at(0.0)[0];
    EXPECT_TRUE(path.is_closed());
    double worst = 0.0;
    for (const Point& p : points_along(to_curve(path), 200)) {
      worst = std::max(worst, std::fabs(std::sqrt(p[0] * p[0] + p[1] * p[1]) - 1.0));
    }
    EXPECT_LE(worst, allowed);
    EXPECT_LE(distance(points_along(to_curve(paths.at(1.0)[0]), 60), keys[1].contours[0]), allowed);
    EXPECT_GE(path.segment_count(), segments);
    segments = path.segment_count();
  }
}

TEST(PathMorph, KeysFarApartKeepTheirOwnShape) {
  const Curve near = to_curve(CubicPath(Points({{0, 0}, {2, 0}, {2, 2}, {0, 3}})));
  const Curve far =
      to_curve(CubicPath(Points({{5e6, 5e6}, {5e6 + 1, 5e6}, {5e6 + 2, 5e6}, {5e6 + 3, 5e6 + 3}})));
  const std::vector<Shape> keys = {{{near}}, {{far}}};
  const PathMorph morph(keys);
  for (const bool line : morph.contours().front().lines) EXPECT_FALSE(line);
}

TEST(PathMorph, MissingContoursCollapse) {
  Shape ring = one(blob(6, 0, 4.0));
  ring.contours.push_back(blob(4, 1.0, 2.0));
  const std::vector<Shape> keys{ring, one(square(9))};
  const PathMorph morph(keys, quick());
  ASSERT_EQ(morph.contours().size(), 2u);
  const std::vector<CubicPath> paths = morph.at(1.0);
  EXPECT_TRUE(paths[1].is_closed());
  EXPECT_EQ(morph.steps()[0].contours[1].a, 1u);
  EXPECT_FALSE(morph.steps()[0].contours[1].b);
  const Points& points = paths[1].control_points();
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_EQ(points[i][0], points[0][0]);
}

TEST(PathMorph, OpenAgainstClosedIsDrawnOpen) {
  const Curve open = Curve::clamped_uniform(3, Points({{0, 0}, {2, 5}, {5, 5}, {8, 1}, {9, -3}}));
  const std::vector<Shape> keys{one(blob(5, 0)), one(open)};
  const PathMorph morph(keys, quick());
  for (const double s : {0.0, 0.5, 1.0}) EXPECT_FALSE(morph.at(s)[0].is_closed());
}

TEST(PathMorph, PairsContoursByWhatTheyAre) {
  // A ring and a dot beside it; the other drawing names its contours in another order, and winds them at
  // will.
  const auto disc = [](double x, double radius) {
    return transform(blob(5, 0.0, radius), Transform::translate(x, 0.0));
  };
  const Shape first{{disc(0, 5), disc(0, 2), disc(14, 3)}, FillRule::evenodd};
  const Shape second{{reverse(disc(15, 3.5)), disc(0, 2.5), reverse(disc(0, 6))}, FillRule::evenodd};
  const std::vector<Shape> keys{first, second};
  const PathMorph morph(keys, quick());
  const std::size_t partner[] = {2, 1, 0};
  ASSERT_EQ(morph.steps()[0].contours.size(), 3u);
  for (const ContourStep& step : morph.steps()[0].contours) EXPECT_EQ(*step.b, partner[*step.a]);
  // Under the nonzero rule the hole stays a hole.
  for (const double s : {0.0, 0.5, 1.0}) {
    EXPECT_GT(signed_area(morph.at(s)[0]), 0.0);
    EXPECT_LT(signed_area(morph.at(s)[1]), 0.0);
    EXPECT_GT(signed_area(morph.at(s)[2]), 0.0);
  }
}

TEST(PathMorph, KeepsContoursThroughKeysInWhichOthersComeAndGo) {
  const auto disc = [](double x) { return transform(blob(4, 0.0, 2.0), Transform::translate(x, 0.0)); };
  const std::vector<Shape> keys{{{disc(0)}}, {{disc(10), disc(0)}}, {{disc(0)}}, {{disc(0), disc(-9)}}};
  const PathMorph morph(keys, quick());
  ASSERT_EQ(morph.contours().size(), 3u);
  for (std::size_t key = 0; key < 4; ++key) {
    std::size_t drawn = 0;
    for (const CubicPath& path : morph.at(static_cast<double>(key) / 3.0)) {
      if (bounding_box(to_curve(path)).diagonal() > 1e-9) ++drawn;
    }
    EXPECT_EQ(drawn, keys[key].contours.size()) << key;
  }
}

// An L becomes its reflection in a diagonal: straight ways would turn it inside out.
TEST(PathMorph, FindsInBetweensThatDoNotCross) {
  const std::vector<Shape> keys{to_shape(parse("M0 0H2V8H10V10H0Z")), to_shape(parse("M0 0H10V10H8V2H0Z"))};
  const PathMorph morph(keys);
  for (int k = 0; k <= 20; ++k) EXPECT_TRUE(is_simple(morph.at(k / 20.0))) << k;
}

TEST(PathMorph, PinsHold) {
  const std::vector<Shape> keys{one(square(10)),
                                {{blob(4, 0), transform(blob(3, 0, 2.0), Transform::translate(20, 0))}}};
  for (const BlendKind kind : kKinds) {
    MorphOptions options = with(kind);
    // A corner, and a point of an edge, each to a place of the smaller contour.
    options.pins = {{{0, 0}, {22, 0.3}}, {{7, 0}, {20, 2}}};
    const PathMorph morph(keys, options);
    ASSERT_EQ(morph.steps()[0].contours[0].b, 1u);
    const Points a = morph.at(0.0)[0].control_points();
    const Points b = morph.at(1.0)[0].control_points();
    for (const MorphPin& pin : options.pins) {
      const NearestPoint on_b = nearest_point(keys[1].contours[1], Point{pin.b.x, pin.b.y});
      const Point wanted = keys[1].contours[1].evaluate(on_b.parameter);
      double nearest = 1e9;
      for (std::size_t i = 0; i < a.size(); i += 3) {
        if (test::apart({a[i][0], a[i][1]}, {pin.a.x, pin.a.y}) > 1e-6) continue;
        nearest = std::min(nearest, test::apart({b[i][0], b[i][1]}, wanted));
      }
      EXPECT_LT(nearest, 1e-6) << static_cast<int>(kind);
    }
  }
  MorphOptions torn;
  torn.pins = {{{0, 0}, {22, 0}}, {{7, 0}, {5, 0}}};
  EXPECT_THROW(PathMorph(keys, torn), InvalidArgument);
  const std::vector<Shape> three{keys[0], keys[0], keys[0]};
  EXPECT_THROW(PathMorph(three, torn), InvalidArgument);
}

TEST(PathMorph, StopsWhenToldTo) {
  const std::vector<Shape> keys{one(blob(3, 0)), one(square(9))};
  for (const int patience : {0, 1, 5, 20}) {
    MorphOptions options = quick();
    int asked = 0;
    options.match.progress = [&](double fraction) {
      EXPECT_GE(fraction, 0.0);
      EXPECT_LE(fraction, 1.0);
      return asked++ < patience;
    };
    EXPECT_TRUE(PathMorph(keys, options).cancelled());
    EXPECT_EQ(asked, patience + 1);
  }
}

TEST(PathMorph, SurvivesPoints) {
  const Curve point = Curve::bezier(Points({{7, 7}, {7, 7}, {7, 7}}), {1, 2, 1});
  const std::vector<Shape> keys{one(point), one(point)};
  const PathMorph morph(keys, quick());
  EXPECT_EQ(morph.at(0.5)[0].segment_count(), 1u);
}

TEST(PathMorph, WantsThePlane) {
  const Curve a = Curve::bezier(Points({{0, 0, 0}, {1, 2, 3}, {4, 1, 0}, {6, 6, 1}}));
  const std::vector<Shape> keys{one(a), one(a)};
  EXPECT_THROW(PathMorph{keys}, InvalidArgument);
}

// An even-odd drawing whose contours lack their last sides, as some icons do, is filled all the same.
TEST(PathMorph, WhatOpenContoursLeaveOutStaysOut) {
  const auto open_square = [](double lo, double hi) {
    PathBuilder builder;
    builder.move_to({lo, lo});
    builder.line_to({hi, lo});
    builder.line_to({hi, hi});
    builder.line_to({lo, hi});
    return to_curve(builder.take().front());
  };
  Shape ring{{open_square(0, 10), open_square(3, 7)}};
  ring.fill_rule = FillRule::evenodd;
  const PathMorph made(std::vector<Shape>{one(square(10)), ring}, quick());
  EXPECT_EQ(made.fill_rule(), FillRule::nonzero);
  const std::vector<CubicPath> drawn = made.at(1);
  ASSERT_EQ(drawn.size(), 2U);
  const double first = signed_area(drawn[0]);
  const double second = signed_area(drawn[1]);
  EXPECT_NEAR(std::fabs(first + second), 100.0 - 16.0, 1e-6);
  EXPECT_NEAR(std::fabs(first - second), 100.0 + 16.0, 1e-6);
}

// Near an end the shape is still in its place: the motion alone must not look like a jump. An intrinsic blend
// of these two swings their ends round at six diagonals per unit of s.
TEST(PathMorph, LeavesItsKeysGently) {
  const auto line = [](const std::vector<Vec2>& points) {
    PathBuilder builder;
    builder.move_to(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) builder.line_to(points[i]);
    return to_curve(builder.take().front());
  };
  const std::vector<Shape> keys{
      one(line({{10, 16}, {10, 8}, {14, 16}, {14, 8}})),
      one(line({{3, 18}, {12, 11.538}, {3, 6}, {3, 18}, {21, 18}, {21, 6}, {12, 11.538}}))};
  const PathMorph made(keys, {});
  for (const double end : {0.0, 1.0}) {
    const double diagonal = bounding_box(keys[end == 0.0 ? 0 : 1]).diagonal();
    const Points there = made.at(end)[0].control_points();
    const Points beside = made.at(std::fabs(end - 2e-4))[0].control_points();
    for (std::size_t i = 0; i < there.size(); ++i) {
      EXPECT_LT(std::hypot(there[i][0] - beside[i][0], there[i][1] - beside[i][1]), 1e-3 * diagonal);
    }
  }
}

}  // namespace
}  // namespace tandem
