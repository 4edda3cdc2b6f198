#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "morph/test_shapes.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/match/rotation.h"
#include "tandem/morph/morph.h"
#include "tandem/morph/moving_frame.h"
#include "tandem/morph/path_morph.h"
#include "tandem/shape/transform.h"

// Spec C11: the turn that the match found is used in the blend.
namespace tandem {
namespace {

using test::apart;
using test::blob;
using test::one;

MorphOptions quick() {
  MorphOptions options;
  options.match.samples = {32, 32};
  return options;
}

/// An L, from its corner.
Curve corner_piece(double x = 0.0, double y = 0.0) {
  PathBuilder builder;
  builder.move_to({x, y});
  for (const Vec2 p : {Vec2{9, 0}, Vec2{9, 2}, Vec2{3, 2}, Vec2{3, 5}, Vec2{0, 5}}) {
    builder.line_to({x + p.x, y + p.y});
  }
  builder.close();
  return to_curve(builder.take().front());
}

Shape turned(const Shape& shape, double degrees, double x = 0.0, double y = 0.0, double seam = 0.0) {
  Shape result = shape;
  for (Curve& curve : result.contours) {
    if (seam > 0.0) curve = move_seam(curve, curve.domain().lo + seam * curve.domain().length());
    curve = transform(curve, Transform::translate(x, y) * Transform::rotate_degrees(degrees));
  }
  return result;
}

/// A closed curve in space without any symmetry.
Curve space_loop() {
  Points points;
  const int n = 9;
  for (int i = 0; i < n + 3; ++i) {
    const double t = 2 * std::numbers::pi * (i % n) / n;
    points.push_back(std::vector<double>{5 * std::cos(t) + std::cos(2 * t), 4 * std::sin(t),
                                         2 * std::sin(3 * t) + std::cos(t + 1)});
  }
  std::vector<double> knots;
  for (int i = 0; i < n + 7; ++i) knots.push_back(i);
  return Curve(3, std::move(knots), std::move(points));
}

std::vector<Point> points_of(const Shape& shape) {
  std::vector<Point> points;
  for (const Curve& curve : shape.contours) {
    for (int k = 0; k < 24; ++k) {
      points.push_back(curve.evaluate(curve.domain().lo + curve.domain().length() * k / 24.0));
    }
  }
  return points;
}

/// Largest change of a distance between two points of the shape.
double strain(const Shape& a, const Shape& b) {
  const std::vector<Point> p = points_of(a);
  const std::vector<Point> q = points_of(b);
  double worst = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k)
      worst = std::max(worst, std::fabs(apart(p[i], p[k]) - apart(q[i], q[k])));
  }
  return worst;
}

TEST(MovingFrame, TakesEachKeyWhereItLies) {
  const double values[] = {0.6, 0.8};
  const MovingFrame frame({1.0, 2.0}, {-3.0, 7.0}, Rotation(2, values));
  const Points a({{1, 1}, {5, 2}, {3, 8}});
  const Points b({{0, 4}, {-2, 2}, {1, 1}});
  const Points first = affine_blend(frame, a, b, 0.0);
  const Points last = affine_blend(frame, a, b, 1.0);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_NEAR(first[i][c], a[i][c], 1e-14);
      EXPECT_NEAR(last[i][c], b[i][c], 1e-14);
    }
  }
  EXPECT_THROW((void)MovingFrame({1.0}, {1.0, 2.0}, Rotation(2)), InvalidArgument);
}

TEST(MovingFrame, ThatStandsStillBlendsInPlace) {
  const Points a({{1, 1}, {5, 2}});
  const Points b({{0, 4}, {-2, 2}});
  const Points between = affine_blend(MovingFrame(2), a, b, 0.25);
  EXPECT_EQ(between, Points({{0.75, 1.75}, {3.25, 2.0}}));
}

TEST(TurningMorph, MovesAShapeAndItsTurnedCopyRigidly) {
  const Shape key{{corner_piece(), corner_piece(20, 3), blob(3, 12)}, FillRule::evenodd};
  for (const double degrees : {7.0, 30.0, 90.0, -150.0}) {
    const std::vector<Shape> keys{key, turned(key, degrees, 30.0, -5.0, 0.3)};
    const Morph morph(keys, quick());
    EXPECT_NEAR(morph.frame(0).rotation().degrees(), degrees, 1e-6);
    for (const double s : {-0.5, 0.1, 0.5, 0.9, 1.3}) {
      EXPECT_LT(strain(morph.at(0.0), morph.at(s)), 1e-6 * 30) << degrees << ' ' << s;
    }
    // It turns about its centre, which moves in a straight line.
    const Box first = bounding_box(morph.at(0.0));
    const Box middle = bounding_box(morph.at(0.5));
    EXPECT_LT(middle.diagonal(), 1.5 * first.diagonal());
  }
}

TEST(TurningMorph, MovesLoopsInSpaceRigidly) {
  const Curve a = space_loop();
  const double values[] = {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0};  // x -> y -> z -> x: 120 degrees
  const Rotation turn(3, values);
  const Curve b(a.degree(), a.knots(), turn(a.control_points()));
  const std::vector<Shape> keys{one(a), one(move_seam(b, a.domain().lo + 2.7))};
  const Morph morph(keys, quick());
  EXPECT_NEAR(morph.frame(0).rotation().degrees(), 120.0, 1e-6);
  for (const double s : {0.25, 0.5, 0.75, 1.0}) EXPECT_LT(strain(morph.at(0.0), morph.at(s)), 1e-5) << s;
}

TEST(TurningMorph, EndsAreTheKeys) {
  const std::vector<Shape> keys{one(corner_piece()), turned(one(blob(2, 4)), 75.0),
                                turned(one(corner_piece()), 75.0)};
  MorphOptions options = quick();
  options.least_gain = 0.0;
  const Morph morph(keys, options);
  const PathMorph paths(keys, options);
  for (std::size_t key = 0; key < 3; ++key) {
    const double s = static_cast<double>(key) / 2.0;
    EXPECT_EQ(morph.at(s).contours[0], morph.keys(0)[key]);
    EXPECT_LT(test::distance(test::points_along(to_curve(paths.at(s)[0]), 60), keys[key].contours[0]),
              1e-4 * 10);
    // And there is no jump beside them.
    for (const double beside : {s - 1e-6, s + 1e-6}) {
      const std::vector<Point> p = points_of(morph.at(s));
      const std::vector<Point> q = points_of(morph.at(beside));
      for (std::size_t i = 0; i < p.size(); ++i) EXPECT_LT(apart(p[i], q[i]), 1e-3);
    }
  }
}

TEST(TurningMorph, PathsFollowTheMorph) {
  // The frame turns, stands still, and turns again.
  const Shape key = one(corner_piece());
  const std::vector<Shape> keys{key, turned(key, 100.0, 3.0, 4.0), turned(key, 100.0, 9.0, 2.0),
                                turned(key, -160.0)};
  const Morph morph(keys, quick());
  const PathMorph paths(keys, quick());
  EXPECT_FALSE(morph.frame(0).stands_still());
  EXPECT_TRUE(morph.frame(1).stands_still());
  ASSERT_EQ(paths.poses().size(), 4u);
  EXPECT_NEAR(paths.poses()[2].degrees, 100.0, 1e-9);
  EXPECT_NEAR(paths.poses()[3].degrees, 200.0, 1e-9);
  for (int k = -3; k <= 33; ++k) {
    const double s = k / 30.0;
    const Curve exact = morph.at(s).contours[0];
    EXPECT_LT(test::distance(test::points_along(to_curve(paths.at(s)[0]), 40), exact), 1e-8) << s;
    if (k < 0 || k > 30) continue;
    Box box = paths.box();
    box.include(bounding_box(exact));
    // Nothing sticks out by more than what a picture leaves free.
    EXPECT_LT(box.diagonal(), 1.02 * paths.box().diagonal());
  }
}

TEST(TurningMorph, DoesNotSpinForATrifle) {
  const std::vector<Shape> keys{one(blob(3, 0)), turned(one(blob(5, 0)), 20.0)};
  EXPECT_TRUE(Morph(keys, quick()).frame(0).stands_still());
  MorphOptions options = quick();
  options.least_gain = 0.0;
  EXPECT_FALSE(Morph(keys, options).frame(0).stands_still());
}

TEST(TurningMorph, StaysWhereTheShapesLieWhenAsked) {
  const std::vector<Shape> keys{one(corner_piece()), turned(one(corner_piece()), 90.0)};
  MorphOptions options = quick();
  EXPECT_FALSE(Morph(keys, options).frame(0).stands_still());
  options.match.rotate = false;
  EXPECT_TRUE(Morph(keys, options).frame(0).stands_still());
  EXPECT_FALSE(PathMorph(keys, options).turns());
  // Norms of positions keep them; the caller may say otherwise, but for the ruled one.
  options.match.rotate.reset();
  for (const NormKind norm : {NormKind::distance, NormKind::bottleneck, NormKind::ruled}) {
    options.match.norm = norm;
    EXPECT_TRUE(Morph(keys, options).frame(0).stands_still());
  }
  options.match.rotate = true;
  EXPECT_THROW((void)Morph(keys, options), InvalidArgument);
}

TEST(TurningMorph, TakesTheRotationOfAMatchOrOfTheCaller) {
  const Curve a = corner_piece();
  const Curve b = turned(one(a), 50.0).contours[0];
  const Match found = match(a, b, {.samples = {32, 32}, .rotate = true});
  EXPECT_NEAR(Morph(a, b, found).frame(0).rotation().degrees(), 50.0, 1e-6);
  MorphOptions options = quick();
  options.match.rotation = {0.0, 1.0};
  const std::vector<Shape> keys{one(a), one(b)};
  const Morph morph(keys, options);
  EXPECT_EQ(morph.frame(0).rotation().degrees(), 90.0);
  EXPECT_LT(test::distance(test::points_along(morph.at(1.0).contours[0], 40), b), 1e-9);
}

}  // namespace
}  // namespace tandem
