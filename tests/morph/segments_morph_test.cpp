#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "match/cubic_paths.h"
#include "morph/loops.h"
#include "tandem/error.h"
#include "tandem/match/segments.h"
#include "tandem/morph/align.h"
#include "tandem/morph/morph.h"
#include "tandem/morph/path_morph.h"
#include "tandem/morph/quality.h"
#include "tandem/morph/segment_blend.h"
#include "tandem/shape/measures.h"

// [D]'s method from two shapes to in-betweens: Method::segments in PathMorph and Morph.

namespace tandem {
namespace {

using cubics::backwards;
using cubics::from_joint;
using cubics::largest_difference;
using cubics::random_path;
using test::smooth_star;
using test::turned;

MorphOptions by_segments() {
  MorphOptions options;
  options.match.method = Method::segments;
  options.match.rotate = false;
  return options;
}

std::vector<Shape> keys_of(const std::vector<CubicPath>& paths) {
  std::vector<Shape> keys;
  for (const CubicPath& path : paths) keys.push_back(Shape{{to_curve(path)}});
  return keys;
}

TEST(SegmentsMorph, BlendsAsTheMethodDoes) {
  std::mt19937 random(1);
  const std::vector<CubicPath> paths{smooth_star(random, 5), smooth_star(random, 6)};
  const auto blend_of = [&](Method method, std::optional<BlendKind> blend) {
    MorphOptions options;
    options.match.method = method;
    options.blend = blend;
    return PathMorph(keys_of(paths), options).steps().front().blend;
  };
  EXPECT_EQ(blend_of(Method::segments, {}), BlendKind::hermite);
  EXPECT_EQ(blend_of(Method::paper, {}), BlendKind::affine);
  EXPECT_EQ(blend_of(Method::segments, BlendKind::intrinsic), BlendKind::intrinsic);
  EXPECT_EQ(blend_of(Method::paper, BlendKind::hermite), BlendKind::hermite);
}

// The in-betweens are the hermite blend of what match_segments() redraws (spec D6).
TEST(SegmentsMorph, HasTheSegmentsOfTheMatch) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 12; ++trial) {
    const CubicPath a = smooth_star(random, 4 + random() % 4);
    const CubicPath b = turned(from_joint(smooth_star(random, 4 + random() % 6), 2), 20.0 * trial, 1.0, 0.0);
    const SegmentMatch match = match_segments(a, b, {.direction = Direction::forward});
    const PathMorph morph(keys_of({a, b}), by_segments());
    const HermiteBlend blend(match.a, match.b);
    for (const double s : {0.0, 0.2, 0.5, 1.0}) {
      const std::vector<CubicPath> now = morph.at(s);
      ASSERT_EQ(now.size(), 1u);
      EXPECT_LT(largest_difference(now.front(), blend.at(s)), 1e-12);
    }
    EXPECT_EQ(morph.steps().front().contours.front().match->report.cost, match.cost);
  }
}

TEST(SegmentsMorph, GoesByTheRulesAsked) {
  std::mt19937 random(4);
  const CubicPath a = smooth_star(random, 3);
  const CubicPath b = smooth_star(random, 8);
  MorphOptions options = by_segments();
  options.match.segments = {SegmentSplit::uniform, SegmentCost::paper};
  const SegmentMatch match = match_segments(
      a, b, {.split = SegmentSplit::uniform, .cost = SegmentCost::paper, .direction = Direction::forward});
  EXPECT_LT(largest_difference(PathMorph(keys_of({a, b}), options).at(0.0).front(), match.a), 1e-12);
  EXPECT_GT(largest_difference(match.a, match_segments(a, b, {.direction = Direction::forward}).a), 1e-3);
}

// Whichever way a loop was drawn, solids are wound alike, so that they do not turn inside out.
TEST(SegmentsMorph, KeepsTheWinding) {
  std::mt19937 random(5);
  const CubicPath a = smooth_star(random, 5);
  const CubicPath b = backwards(smooth_star(random, 6));
  const PathMorph morph(keys_of({a, b}), by_segments());
  const auto area = [&](double s) { return std::fabs(signed_area(morph.at(s).front())); };
  for (const double s : {0.25, 0.5, 0.75}) {
    EXPECT_GT(area(s), 0.8 * std::min(area(0.0), area(1.0)));
  }
  EXPECT_EQ(measure_quality(morph).faulty, 0u);
}

TEST(SegmentsMorph, CutsALoopAgainstAStroke) {
  std::mt19937 random(6);
  const CubicPath loop = smooth_star(random, 6);
  const CubicPath stroke = random_path(random, 2, 4, false);
  for (const bool swapped : {false, true}) {
    const CubicPath& a = swapped ? stroke : loop;
    const CubicPath& b = swapped ? loop : stroke;
    const PathMorph morph(keys_of({a, b}), by_segments());
    const SegmentMatch match = match_segments(a, b);
    ASSERT_EQ(morph.contours().size(), 1u);
    EXPECT_FALSE(morph.at(0.5).front().is_closed());
    EXPECT_EQ(morph.at(0.5).front().segment_count(), match.a.segment_count());
  }
}

TEST(SegmentsMorph, PairsSeveralContours) {
  std::mt19937 random(7);
  const auto drawing = [&](double scale) {
    Shape shape;
    for (const double x : {0.0, 5.0}) {
      const CubicPath outer = turned(smooth_star(random, 5 + random() % 3), 0.0, scale * x, 0.0);
      shape.contours.push_back(to_curve(outer));
      Points hole = outer.control_points();
      for (std::size_t i = 0; i < hole.size(); ++i) {
        hole[i][0] = scale * x + 0.4 * (hole[i][0] - scale * x);
        hole[i][1] *= 0.4;
      }
      shape.contours.push_back(to_curve(backwards(CubicPath(std::move(hole), true))));
    }
    return shape;
  };
  const std::vector<Shape> keys{drawing(1.0), drawing(1.3)};
  const PathMorph morph(keys, by_segments());
  ASSERT_EQ(morph.contours().size(), 4u);
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(morph.steps()[0].contours[c].a, c);
    EXPECT_EQ(morph.steps()[0].contours[c].b, c);
  }
  const MorphQuality quality = measure_quality(morph);
  EXPECT_EQ(quality.faulty, 0u);
  EXPECT_LE(quality.g1_defect, 1e-9);
}

// Three keys: every step is a match of segments, and the last key is what it was.
TEST(SegmentsMorph, GoesThroughSeveralKeys) {
  std::mt19937 random(8);
  const std::vector<CubicPath> paths{smooth_star(random, 4), smooth_star(random, 6), smooth_star(random, 5)};
  const PathMorph morph(keys_of(paths), by_segments());
  for (std::size_t key = 0; key < 3; ++key) {
    const CubicPath now = morph.at(static_cast<double>(key) / 2.0).front();
    EXPECT_NEAR(signed_area(now), signed_area(paths[key]), 1e-12);
    EXPECT_LE(test::largest_turn(now), 1e-9);
  }
  for (const double s : {0.2, 0.4, 0.6, 0.9}) EXPECT_LE(test::largest_turn(morph.at(s).front()), 1e-9);
}

// Lines that must bend to stay smooth are not drawn as lines.
TEST(SegmentsMorph, TellsLinesThatBend) {
  const auto line = [](double x0, double y0, double x1, double y1, double x2, double y2) {
    Points points;
    points.push_back(Point{x0, y0});
    for (const double t : {1.0, 2.0, 3.0})
      points.push_back(Point{x0 + (x1 - x0) * t / 3, y0 + (y1 - y0) * t / 3});
    for (const double t : {1.0, 2.0, 3.0})
      points.push_back(Point{x1 + (x2 - x1) * t / 3, y1 + (y2 - y1) * t / 3});
    return CubicPath(std::move(points));
  };
  const std::vector<CubicPath> paths{line(0, 0, 1, 0, 4, 0), line(0, 0, 0, 3, 0, 4)};
  MorphOptions options = by_segments();
  options.match.direction = Direction::forward;
  options.pins = {{{1, 0}, {0, 3}}};
  const PathMorph morph(keys_of(paths), options);
  ASSERT_EQ(morph.contours().front().lines.size(), 2u);
  const CubicPath now = morph.at(0.5).front();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(morph.contours().front().lines[i], now.is_line(i, 1e-9)) << i;
    EXPECT_FALSE(morph.contours().front().lines[i]);
  }
}

// Pins are points of the outlines; the nearest ones become one another on the way.
TEST(SegmentsMorph, PinsHold) {
  std::mt19937 random(9);
  const CubicPath a = smooth_star(random, 5);
  const CubicPath b = smooth_star(random, 6);
  const Point on_a = to_curve(a).evaluate(1.3);
  const Point on_b = to_curve(b).evaluate(4.6);
  MorphOptions options = by_segments();
  options.pins = {{{on_a[0], on_a[1]}, {on_b[0], on_b[1]}}};
  const PathMorph morph(keys_of({a, b}), options);
  const SegmentMatch match = match_segments(a, b, {.direction = Direction::forward, .pins = {{1.3, 4.6}}});
  EXPECT_EQ(morph.contours().front().lines.size(), match.a.segment_count());
  const CubicPath first = morph.at(0.0).front();
  const CubicPath last = morph.at(1.0).front();
  bool met = false;
  for (std::size_t j = 0; j < first.segment_count(); ++j) {
    const auto p = first.control_points()[3 * j];
    const auto q = last.control_points()[3 * j];
    met = met || (std::hypot(p[0] - on_a[0], p[1] - on_a[1]) < 1e-6 &&
                  std::hypot(q[0] - on_b[0], q[1] - on_b[1]) < 1e-6);
  }
  EXPECT_TRUE(met);
  EXPECT_LE(measure_quality(morph).g1_defect, 1e-9);
}

// --- in space ---

TEST(SegmentsMorph, BlendsCurvesInSpace) {
  std::mt19937 random(10);
  for (int trial = 0; trial < 8; ++trial) {
    const bool closed = trial % 2 == 0;
    const CubicPath a = closed ? cubics::smooth_loop(random, 3, 4) : random_path(random, 3, 4, false);
    const CubicPath b = closed ? cubics::smooth_loop(random, 3, 6) : random_path(random, 3, 6, false);
    const SegmentMatch match = match_segments(a, b);
    const HermiteBlend blend(match.a, match.b);
    const Morph morph(keys_of({a, b}), by_segments());
    for (const double s : {-0.2, 0.0, 0.3, 0.5, 1.0, 1.1}) {
      const Shape now = morph.at(s);
      ASSERT_EQ(now.contours.size(), 1u);
      const CubicPath drawn = to_cubic_path(now.contours.front(), 1.0);
      EXPECT_LT(largest_difference(drawn, blend.at(s)), 1e-11) << "at " << s;
      EXPECT_EQ(now.contours.front().is_closed(), closed);
    }
    MorphOptions affine = by_segments();
    affine.blend = BlendKind::affine;
    const Shape half = Morph(keys_of({a, b}), affine).at(0.5);
    EXPECT_LT(
        largest_difference(to_cubic_path(half.contours.front(), 1.0), bezier_blend(match.a, match.b, 0.5)),
        1e-11);
  }
}

// A turned and moved copy goes there as one body, in space as well.
TEST(SegmentsMorph, TurnsCopiesInSpace) {
  std::mt19937 random(11);
  const CubicPath a = cubics::smooth_loop(random, 3, 6);
  const double c = std::cos(0.8);
  const double s = std::sin(0.8);
  Points points = a.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p(points[i].begin(), points[i].end());
    points[i][0] = p[0];
    points[i][1] = c * p[1] - s * p[2] + 3.0;
    points[i][2] = s * p[1] + c * p[2];
  }
  MorphOptions options = by_segments();
  options.match.rotate = true;
  const Morph morph(keys_of({a, CubicPath(std::move(points), true)}), options);
  const auto edges = [](const Points& p) {
    std::vector<double> lengths;
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
      lengths.push_back(std::hypot(p[i + 1][0] - p[i][0], p[i + 1][1] - p[i][1], p[i + 1][2] - p[i][2]));
    }
    return lengths;
  };
  const std::vector<double> wanted = edges(a.control_points());
  const std::vector<double> half = edges(morph.at(0.5).contours.front().control_points());
  ASSERT_EQ(half.size(), wanted.size());
  for (std::size_t i = 0; i < half.size(); ++i) EXPECT_NEAR(half[i], wanted[i], 1e-4);
}

TEST(SegmentsMorph, GoesThroughSeveralKeysInSpace) {
  std::mt19937 random(12);
  const std::vector<CubicPath> paths{cubics::smooth_loop(random, 3, 3), cubics::smooth_loop(random, 3, 5),
                                     cubics::smooth_loop(random, 3, 4)};
  const Morph morph(keys_of(paths), by_segments());
  const std::size_t segments = to_cubic_path(morph.at(0.0).contours.front(), 1.0).segment_count();
  for (const double s : {0.0, 0.25, 0.5, 0.6, 1.0}) {
    const Curve now = morph.at(s).contours.front();
    EXPECT_EQ(to_cubic_path(now, 1.0).segment_count(), segments);
    // Smooth at every joint.
    const Points& p = now.control_points();
    for (std::size_t j = 0; j < segments; ++j) {
      const std::size_t before = j == 0 ? p.size() - 2 : 3 * j - 1;
      double dot = 0.0;
      double in = 0.0;
      double out = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = p[3 * j][k] - p[before][k];
        const double y = p[3 * j + 1][k] - p[3 * j][k];
        dot += x * y;
        in += x * x;
        out += y * y;
      }
      EXPECT_NEAR(dot, std::sqrt(in * out), 1e-9 * std::sqrt(in * out)) << "joint " << j << " at " << s;
    }
  }
}

TEST(SegmentsMorph, SaysWhatIsWrongInSpace) {
  std::mt19937 random(13);
  const std::vector<CubicPath> paths{random_path(random, 3, 3, false), random_path(random, 3, 5, false)};
  MorphOptions options = by_segments();
  options.blend = BlendKind::intrinsic;
  EXPECT_THROW((void)Morph(keys_of(paths), options), InvalidArgument);
  const Curve quintic = Curve::clamped_uniform(
      5, Points({{0, 0, 0}, {1, 2, 0}, {2, -1, 1}, {3, 3, 0}, {4, 0, 0}, {5, 1, 2}, {6, 6, 0}}));
  MorphOptions elastic;
  elastic.blend = BlendKind::hermite;
  const std::vector<Shape> keys{Shape{{quintic}}, Shape{{quintic}}};
  EXPECT_THROW((void)Morph(keys, elastic), InvalidArgument);
  // By segments the quintic is taken as cubics.
  const Shape half = Morph(keys, by_segments()).at(0.5);
  EXPECT_EQ(half.contours.front().degree(), 3);
}

TEST(CutInStep, WantsPiecesOfSegments) {
  std::mt19937 random(14);
  const CubicPath a = random_path(random, 2, 3, false);
  const CubicPath b = random_path(random, 2, 2, false);
  const AlignedPaths cut = cut_in_step(a, b, match_segments(a, b).correspondence);
  EXPECT_EQ(cut.a.segment_count(), 3u);
  const Correspondence c{{{0, 0}, {3, 2}}, {0, 3}, {0, 2}, false, false};
  EXPECT_THROW((void)cut_in_step(a, b, c), InvalidArgument);
}

}  // namespace
}  // namespace tandem
