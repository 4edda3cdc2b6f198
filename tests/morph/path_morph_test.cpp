#include "tandem/morph/path_morph.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <vector>

#include "morph/test_shapes.h"
#include "tandem/error.h"

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

// Segment k is the span k of the compatible curves, for cubics to rounding.
TEST(PathMorph, RedrawsTheKeys) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Shape> keys{one(any_outline()), one(any_outline())};
    const Morph exact(keys, quick());
    const PathMorph morph(exact);
    for (std::size_t key = 0; key < 2; ++key) {
      const std::vector<CubicPath> paths = morph.at(static_cast<double>(key));
      RC_ASSERT(paths.size() == 1u);
      RC_ASSERT(paths[0].is_closed());
      const Curve drawn = to_curve(paths[0]);
      const Curve& curve = exact.keys(0)[key];
      const std::vector<Knot> knots = distinct_knots(curve.knots());
      RC_ASSERT(paths[0].segment_count() == knots.size() - 1);
      for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
        for (const double t : {0.0, 0.3, 0.7}) {
          const double u = knots[k].value + t * (knots[k + 1].value - knots[k].value);
          RC_ASSERT(test::apart(drawn.evaluate(static_cast<double>(k) + t), curve.evaluate(u)) <= 1e-11);
        }
      }
    }
  }));
}

TEST(PathMorph, KeepsTheStructureAndBlendsPoints) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Shape> keys{one(any_outline()), one(any_outline()), one(any_outline())};
    const PathMorph morph{Morph(keys, unturned())};
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

// The paths and the morph itself are the same in-between.
TEST(PathMorph, FollowsTheMorph) {
  const std::vector<Shape> keys{one(blob(3, 0)), one(square(9))};
  const Morph morph(keys);
  const PathMorph paths(morph);
  for (const double s : {0.0, 0.3, 0.5, 1.0, 1.4}) {
    const Curve between = morph.at(s).contours[0];
    const Curve drawn = to_curve(paths.at(s)[0]);
    EXPECT_LE(distance(points_along(between, 60), drawn), 1e-9) << s;
    EXPECT_LE(distance(points_along(drawn, 60), between), 1e-9) << s;
  }
}

TEST(PathMorph, LinesStayLines) {
  const std::vector<Shape> keys{one(square(10)), one(square(4))};
  const PathMorph morph{Morph(keys, quick())};
  for (const bool line : morph.contours()[0].lines) EXPECT_TRUE(line);
  const std::vector<Shape> mixed{one(square(10)), one(blob(4, 5))};
  const PathMorph other{Morph(mixed, quick())};
  for (const bool line : other.contours()[0].lines) EXPECT_FALSE(line);
}

TEST(PathMorph, ApproximatesWhatIsNoCubic) {
  const double w = std::sqrt(0.5);
  // The unit circle as a rational quadratic.
  const Curve circle(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
                     Points({{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}),
                     {1, w, 1, w, 1, w, 1, w, 1});
  const std::vector<Shape> keys{one(circle), one(square(3))};
  const Morph morph(keys);
  std::size_t segments = 0;
  for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
    const PathMorph paths(morph, tolerance);
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
  const PathMorph morph{Morph(keys)};
  for (const bool line : morph.contours().front().lines) EXPECT_FALSE(line);
}

TEST(PathMorph, MissingContoursCollapse) {
  Shape ring = one(blob(6, 0, 4.0));
  ring.contours.push_back(blob(4, 1.0, 2.0));
  const std::vector<Shape> keys{ring, one(square(9))};
  const PathMorph morph{Morph(keys, quick())};
  ASSERT_EQ(morph.contours().size(), 2u);
  const std::vector<CubicPath> paths = morph.at(1.0);
  EXPECT_TRUE(paths[1].is_closed());
  const Points& points = paths[1].control_points();
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_EQ(points[i][0], points[0][0]);
}

TEST(PathMorph, OpenAgainstClosedIsDrawnOpen) {
  const Curve open = Curve::clamped_uniform(3, Points({{0, 0}, {2, 5}, {5, 5}, {8, 1}, {9, -3}}));
  const std::vector<Shape> keys{one(blob(5, 0)), one(open)};
  const PathMorph morph{Morph(keys, quick())};
  for (const double s : {0.0, 0.5, 1.0}) EXPECT_FALSE(morph.at(s)[0].is_closed());
}

TEST(PathMorph, SurvivesPoints) {
  const Curve point = Curve::bezier(Points({{7, 7}, {7, 7}, {7, 7}}), {1, 2, 1});
  const std::vector<Shape> keys{one(point), one(point)};
  const PathMorph morph{Morph(keys, quick())};
  EXPECT_EQ(morph.at(0.5)[0].segment_count(), 1u);
}

TEST(PathMorph, WantsThePlane) {
  const Curve a = Curve::bezier(Points({{0, 0, 0}, {1, 2, 3}, {4, 1, 0}, {6, 6, 1}}));
  const std::vector<Shape> keys{one(a), one(a)};
  EXPECT_THROW(PathMorph{Morph(keys)}, InvalidArgument);
}

}  // namespace
}  // namespace tandem
