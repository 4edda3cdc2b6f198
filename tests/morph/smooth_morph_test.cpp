#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "morph/test_shapes.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/morph/key_frames.h"
#include "tandem/morph/morph.h"
#include "tandem/morph/path_morph.h"
#include "tandem/morph/quality.h"
#include "tandem/shape/measures.h"
#include "tandem/shape/path_builder.h"

namespace tandem {
namespace {

using test::any_outline;
using test::blob;
using test::one;

MorphOptions smooth(BlendKind blend = BlendKind::automatic) {
  MorphOptions options;
  options.match.samples = {24, 24};
  options.match.rotate = false;
  options.blend = blend;
  options.smooth = true;
  return options;
}

std::vector<double> coordinates(const std::vector<CubicPath>& paths) {
  std::vector<double> all;
  for (const CubicPath& path : paths) {
    const auto data = path.control_points().data();
    all.insert(all.end(), data.begin(), data.end());
  }
  return all;
}

std::vector<double> coordinates(const Shape& shape) {
  std::vector<double> all;
  for (const Curve& curve : shape.contours) {
    const auto data = curve.control_points().data();
    all.insert(all.end(), data.begin(), data.end());
  }
  return all;
}

// Largest difference of the velocities just before and just behind s, by one-sided differences of the second
// order, relative to the largest of them.
template <class AnyMorph>
double velocity_break(const AnyMorph& morph, double s) {
  constexpr double h = 1e-4;
  const std::vector<double> at = coordinates(morph.at(s));
  const auto velocity = [&](double step) {
    std::vector<double> one_sided = coordinates(morph.at(s + step));
    const std::vector<double> two = coordinates(morph.at(s + 2 * step));
    for (std::size_t i = 0; i < at.size(); ++i)
      one_sided[i] = (4 * one_sided[i] - two[i] - 3 * at[i]) / (2 * step);
    return one_sided;
  };
  const std::vector<double> before = velocity(-h);
  const std::vector<double> behind = velocity(h);
  double largest = 0.0;
  double speed = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    largest = std::max(largest, std::fabs(behind[i] - before[i]));
    speed = std::max({speed, std::fabs(behind[i]), std::fabs(before[i])});
  }
  return speed > 0.0 ? largest / speed : 0.0;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
  return largest;
}

Curve bar(double width, double height) {
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.line_to({width, 0});
  builder.line_to({width, height});
  builder.line_to({0, height});
  builder.close();
  return to_curve(builder.take().front());
}

constexpr BlendKind kKinds[] = {BlendKind::automatic, BlendKind::affine,     BlendKind::bezier,
                                BlendKind::hermite,   BlendKind::similarity, BlendKind::intrinsic,
                                BlendKind::detour};

TEST(SmoothMorph, PassesTheKeysWithoutABreakOfVelocity) {
  const std::vector<Shape> keys{one(blob(3, 0)), one(bar(9, 9)), one(blob(5, 4)), one(blob(4, 2))};
  for (const BlendKind kind : kKinds) {
    MorphOptions options = smooth(kind);
    options.times = {0, 0.2, 0.55, 1};
    const PathMorph morph(keys, options);
    options.smooth = false;
    const PathMorph plain(keys, options);
    ASSERT_TRUE(morph.is_smooth());
    EXPECT_FALSE(morph.is_linear());
    for (const double s : options.times) {
      EXPECT_LE(largest_difference(coordinates(morph.at(s)), coordinates(plain.at(s))), 1e-12) << s;
    }
    for (const double s : {0.2, 0.55}) {
      EXPECT_LE(velocity_break(morph, s), 1e-3) << s << " blend " << static_cast<int>(kind);
      EXPECT_GE(velocity_break(plain, s), 0.1) << s << " blend " << static_cast<int>(kind);
    }
  }
}

TEST(SmoothMorph, TurnsSmoothlyToo) {
  const Curve first = bar(9, 2);
  const std::vector<Shape> keys{one(first), one(transform(first, Transform::rotate_degrees(60))),
                                one(transform(first, Transform::rotate_degrees(80)))};
  MorphOptions options = smooth();
  options.match.rotate = true;
  options.match.direction = Direction::forward;
  const PathMorph morph(keys, options);
  ASSERT_TRUE(morph.turns());
  EXPECT_LE(velocity_break(morph, 0.5), 1e-3);
  // A body that only turns stays the body that it is.
  const auto edge = [](const CubicPath& path) {
    const auto p = path.control_points()[0];
    const auto q = path.control_points()[3];
    return std::hypot(p[0] - q[0], p[1] - q[1]);
  };
  const double first_edge = edge(morph.at(0.0)[0]);
  for (const double s : {0.1, 0.3, 0.45, 0.6, 0.9}) EXPECT_NEAR(edge(morph.at(s)[0]), first_edge, 1e-9) << s;
  // Frames with poses are within their tolerance of it.
  for (const bool bake : {false, true}) {
    const KeyFrames frames = key_frames(morph, {.tolerance = 1e-3, .bake_turn = bake});
    EXPECT_LE(frames.max_error, 1e-3);
    EXPECT_EQ(frames.poses.empty(), bake);
    EXPECT_GT(frames.times.size(), 3u);
    EXPECT_TRUE(frames.smooth);
  }
}

TEST(SmoothMorph, IsTheOrdinaryOneForTwoKeysAndForEvenMotion) {
  const std::vector<Shape> two{one(blob(3, 0)), one(bar(9, 9))};
  MorphOptions plain = smooth();
  plain.smooth = false;
  const PathMorph a(two, smooth());
  const PathMorph b(two, plain);
  EXPECT_FALSE(a.is_smooth());
  for (const double s : {-0.2, 0.0, 0.3, 1.0}) EXPECT_EQ(coordinates(a.at(s)), coordinates(b.at(s)));
  // Three keys on the way of an even motion: no velocity to correct.
  const Curve body = blob(3, 0);
  const std::vector<Shape> keys{one(body), one(transform(body, Transform::translate(1, 2))),
                                one(transform(body, Transform::translate(4, 8)))};
  MorphOptions timed = smooth();
  timed.times = {0, 0.25, 1};
  const PathMorph morph(keys, timed);
  const std::vector<double> start = coordinates(morph.at(0.0));
  for (const double s : {0.1, 0.25, 0.5, 0.8}) {
    const std::vector<double> now = coordinates(morph.at(s));
    for (std::size_t i = 0; i < now.size(); ++i) {
      EXPECT_NEAR(now[i], start[i] + s * (i % 2 == 0 ? 4 : 8), 1e-6) << s;
    }
  }
}

// Seen through any affine map, the motion is the one between the mapped keys (of the same correspondence):
// the cubic Hermite one with the velocity of the parabola through three keys.
TEST(SmoothMorph, IsAffineInvariant) {
  EXPECT_TRUE(rc::check("in-betweens of mapped keys are mapped in-betweens", [] {
    const auto number = [] { return *rc::gen::inRange(-20, 21) / 10.0; };
    const Transform map{1.0 + 0.2 * number(), 0.3 * number(), 0.3 * number(),
                        1.0 + 0.2 * number(), number(),       number()};
    const std::vector<Shape> keys{one(any_outline()), one(any_outline()), one(any_outline())};
    MorphOptions options = smooth();
    const double t1 = 0.3;
    options.times = {0, t1, 1};
    const Morph morph(keys, options);
    const double s = *rc::gen::inRange(0, 101) / 100.0;
    const std::vector<double> got = coordinates(Shape{{transform(morph.at(s).contours[0], map)}});
    std::vector<std::vector<double>> p;
    for (const Curve& key : morph.keys(0)) p.push_back(coordinates(Shape{{transform(key, map)}}));
    for (std::size_t i = 0; i < got.size(); ++i) {
      const double d0 = (p[1][i] - p[0][i]) / t1;
      const double d1 = (p[2][i] - p[1][i]) / (1 - t1);
      const double v = (1 - t1) * d0 + t1 * d1;
      const bool first = s <= t1;
      const double x = first ? s / t1 : (s - t1) / (1 - t1);
      const double wanted =
          first ? (1 - x) * p[0][i] + x * p[1][i] - x * x * (1 - x) * t1 * (v - d0)
                : (1 - x) * p[1][i] + x * p[2][i] + x * (1 - x) * (1 - x) * (1 - t1) * (v - d1);
      RC_ASSERT(std::fabs(got[i] - wanted) <= 1e-8);
    }
  }));
}

TEST(SmoothMorph, GoesThroughCurvesInSpace) {
  std::vector<Shape> keys;
  for (const auto& [radius, rise] : {std::pair{2.0, 0.3}, {3.0, 0.1}, {1.0, 0.5}, {2.0, 0.4}}) {
    Points points;
    for (int i = 0; i < 12; ++i) {
      points.push_back(Point{radius * std::cos(0.6 * i), radius * std::sin(0.6 * i), rise * i});
    }
    std::vector<double> knots{0, 0, 0};
    for (int i = 0; i <= 9; ++i) knots.push_back(i / 9.0);
    knots.insert(knots.end(), {1, 1, 1});
    keys.push_back(one(Curve(3, std::move(knots), std::move(points))));
  }
  MorphOptions options = smooth();
  options.times = {0, 0.3, 0.5, 1};
  for (const bool rotate : {false, true}) {
    options.match.rotate = rotate;
    options.smooth = true;
    const Morph morph(keys, options);
    options.smooth = false;
    const Morph plain(keys, options);
    EXPECT_EQ(morph.key_times(), options.times);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LE(
          largest_difference(coordinates(morph.at(options.times[k])), coordinates(Shape{{morph.keys(0)[k]}})),
          1e-12);
    }
    for (const double s : {0.3, 0.5}) {
      EXPECT_LE(velocity_break(morph, s), 1e-4) << s;
      EXPECT_GE(velocity_break(plain, s), 0.1) << s;
    }
    EXPECT_EQ(morph.at(-0.3), plain.at(-0.3));
  }
}

// A contour that grows out of a point must not be turned inside out before it is born.
TEST(SmoothMorph, PointsDoNotSwingBeforeTheyAreBorn) {
  Shape ring = one(blob(6, 0, 8.0));
  ring.contours.push_back(reverse(blob(4, 0.0, 2.0)));
  const std::vector<Shape> keys{one(blob(6, 0, 8.0)), one(blob(5, 1, 8.0)), ring, one(blob(4, 0, 8.0))};
  const PathMorph morph(keys, smooth(BlendKind::affine));
  ASSERT_EQ(morph.contours().size(), 2u);
  for (const double s : {0.05, 0.2, 0.3, 0.33}) {
    const std::vector<double> points = coordinates({morph.at(s)[1]});
    for (std::size_t i = 2; i < points.size(); ++i) EXPECT_NEAR(points[i], points[i % 2], 1e-9) << s;
  }
  EXPECT_LE(velocity_break(morph, 1.0 / 3.0), 1e-3);
  EXPECT_EQ(measure_quality(morph).faulty, 0u);
}

// Velocity just behind the start minus that just before the end, relative to the larger of the two.
double joint_break(const PathMorph& morph) {
  constexpr double h = 1e-4;
  const auto velocity = [&](double s, double step) {
    std::vector<double> at = coordinates(morph.at(s));
    const std::vector<double> one = coordinates(morph.at(s + step));
    const std::vector<double> two = coordinates(morph.at(s + 2 * step));
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = (4 * one[i] - two[i] - 3 * at[i]) / (2 * step);
    return at;
  };
  const std::vector<double> start = velocity(0.0, h);
  const std::vector<double> end = velocity(1.0, -h);
  double speed = 0.0;
  for (std::size_t i = 0; i < start.size(); ++i)
    speed = std::max({speed, std::fabs(start[i]), std::fabs(end[i])});
  return largest_difference(start, end) / speed;
}

Curve hook() {
  PathBuilder builder;
  builder.move_to({0, 0});
  for (const Vec2 corner : {Vec2{9, 0}, {9, 2}, {3, 2}, {3, 5}, {0, 5}}) builder.line_to(corner);
  builder.close();
  return to_curve(builder.take().front());
}

// Keys of one kind, whose matches bring every joint back to where it was.
TEST(SmoothMorph, ClosesLoops) {
  const std::vector<Shape> loop{one(hook()), one(transform(hook(), Transform{1.4, 0.2, 0.0, 0.8, 3.0, 0.0})),
                                one(transform(hook(), Transform{0.8, 0.0, 0.3, 1.2, 0.0, 2.0})), one(hook())};
  for (const BlendKind kind : {BlendKind::affine, BlendKind::hermite, BlendKind::automatic}) {
    MorphOptions options = smooth(kind);
    options.times = {0, 0.2, 0.55, 1};
    const PathMorph morph(loop, options);
    options.smooth = false;
    const PathMorph plain(loop, options);
    EXPECT_LE(joint_break(morph), 1e-3) << static_cast<int>(kind);
    EXPECT_GE(joint_break(plain), 0.1) << static_cast<int>(kind);
    for (const double s : {0.0, 1.0})
      EXPECT_LE(largest_difference(coordinates(morph.at(s)), coordinates(plain.at(s))), 1e-12) << s;
    EXPECT_EQ(morph.pace().front(), morph.pace().back());
  }
  // What does not come back is not bent at its ends.
  const std::vector<Shape> way{one(blob(3, 0)), one(bar(9, 9)), one(blob(5, 4)), one(blob(4, 2))};
  EXPECT_GE(joint_break(PathMorph(way, smooth(BlendKind::affine))), 0.1);
}

TEST(SmoothMorph, ClosesTurnsOfAWholeRound) {
  std::vector<Shape> keys;
  for (const double degrees : {0.0, 90.0, 180.0, 270.0, 360.0}) {
    keys.push_back(one(transform(hook(), Transform::rotate_degrees(degrees))));
  }
  MorphOptions options = smooth();
  options.match.rotate = true;
  options.match.direction = Direction::forward;
  const PathMorph morph(keys, options);
  EXPECT_NEAR(morph.poses().back().degrees, 360.0, 1e-6);
  EXPECT_LE(joint_break(morph), 1e-3);
  options.smooth = false;
  EXPECT_GE(joint_break(PathMorph(keys, options)), 0.1);
}

// A bar that thins quickly and then stays thin would be turned inside out by a spline through the keys.
TEST(SmoothMorph, SlowsDownWhereItWouldCross) {
  const std::vector<Shape> keys{one(bar(10, 10)), one(bar(10, 0.2)), one(bar(10, 0.3))};
  MorphOptions options = smooth(BlendKind::affine);
  const PathMorph morph(keys, options);
  EXPECT_EQ(measure_quality(morph).faulty, 0u);
  EXPECT_LT(morph.pace()[1], 1.0);
  EXPECT_EQ(morph.pace().front(), 1.0);
  EXPECT_LE(velocity_break(morph, 0.5), 1e-3);
  const std::vector<Shape> easy{one(bar(10, 10)), one(bar(10, 8)), one(bar(10, 7))};
  EXPECT_EQ(PathMorph(easy, options).pace(), (std::vector<double>{1, 1, 1}));
}

TEST(KeyTimes, SayWhereTheKeysStand) {
  const std::vector<Shape> keys{one(blob(3, 0)), one(bar(9, 9)), one(blob(5, 4))};
  MorphOptions options = smooth();
  options.smooth = false;
  const PathMorph even(keys, options);
  EXPECT_EQ(even.key_times(), (std::vector<double>{0, 0.5, 1}));
  options.times = {0, 0.2, 1};
  const PathMorph morph(keys, options);
  EXPECT_LE(largest_difference(coordinates(morph.at(0.2)), coordinates(even.at(0.5))), 1e-12);
  EXPECT_LE(largest_difference(coordinates(morph.at(0.1)), coordinates(even.at(0.25))), 1e-9);
  EXPECT_LE(largest_difference(coordinates(morph.at(0.6)), coordinates(even.at(0.75))), 1e-9);
  const KeyFrames frames = key_frames(morph);
  ASSERT_EQ(frames.keys.size(), 3u);
  EXPECT_EQ(frames.times[frames.keys[1]], 0.2);
  const Morph curves(keys, options);
  EXPECT_EQ(curves.at(0.2).contours[0], curves.keys(0)[1]);
  // The same quality, on the same in-betweens.
  EXPECT_NEAR(measure_quality(morph).length_deviation, measure_quality(even).length_deviation, 1e-9);
}

TEST(KeyTimes, RiseFromZeroToOne) {
  const std::vector<Shape> keys{one(bar(2, 2)), one(bar(3, 2)), one(bar(3, 3))};
  for (const std::vector<double>& bad : {std::vector<double>{0, 1},
                                         {0, 0.5, 0.9},
                                         {0.1, 0.5, 1},
                                         {0, 0, 1},
                                         {0, 1, 1},
                                         {0, 2, 1},
                                         {0, std::nan(""), 1},
                                         {0, 0.2, 0.5, 1}}) {
    MorphOptions options = smooth();
    options.times = bad;
    EXPECT_THROW((void)PathMorph(keys, options), InvalidArgument);
    EXPECT_THROW((void)Morph(keys, options), InvalidArgument);
  }
  const std::vector<double> times{0, 0.25, 1};
  EXPECT_EQ(locate_key(0.25, times).key, 1u);
  EXPECT_EQ(locate_key(0.25, times).local, 0.0);
  EXPECT_EQ(locate_key(1.0, times).local, 1.0);
  EXPECT_EQ(locate_key(-0.25, times).local, -1.0);
  EXPECT_EQ(locate_key(1.75, times).local, 2.0);
  EXPECT_THROW((void)locate_key(std::nan(""), times), InvalidArgument);
}

// Spec C14: a contour's parametrisation at a key is common to both steps, so that correspondences compose.
TEST(KeyChain, ComesBackToWhereItStarted) {
  for (const Curve& other : {blob(5, 1), bar(9, 9)}) {
    const std::vector<Shape> keys{one(blob(3, 0)), one(other), one(blob(3, 0))};
    MorphOptions options = smooth(BlendKind::affine);
    options.smooth = false;
    const PathMorph morph(keys, options);
    const CubicPath& first = morph.contours()[0].keys.front();
    const CubicPath& last = morph.contours()[0].keys.back();
    double largest = 0.0;
    for (std::size_t i = 0; i < first.control_points().size(); i += 3) {
      const auto p = first.control_points()[i];
      const auto q = last.control_points()[i];
      largest = std::max(largest, std::hypot(p[0] - q[0], p[1] - q[1]));
    }
    // Joints lie within the tolerance of the fit of where they were, of a length of 35.
    EXPECT_LE(largest, 0.35);
  }
}

// Distance of a point from a path, by dense samples.
double distance_from(const CubicPath& path, std::span<const double> p) {
  const Curve curve = to_curve(path);
  const Interval domain = curve.domain();
  double least = std::numeric_limits<double>::infinity();
  constexpr int kSamples = 20'000;
  for (int i = 0; i <= kSamples; ++i) {
    const Point q = curve.evaluate(domain.lo + domain.length() * i / kSamples);
    least = std::min(least, std::hypot(q[0] - p[0], q[1] - p[1]));
  }
  return least;
}

// A, B, C, A: the last key is the first one's outline exactly. Its joints are those that the three matches
// hand on, which need not be where they started: nothing makes the best matches of A and B, B and C, C and A
// agree.
TEST(KeyChain, LoopsOfThreeKeysComeBack) {
  const std::vector<Shape> keys{one(blob(3, 0)), one(blob(5, 1)), one(bar(9, 9)), one(blob(3, 0))};
  for (const BlendKind kind : {BlendKind::affine, BlendKind::automatic}) {
    MorphOptions options = smooth(kind);
    options.smooth = false;
    const PathMorph morph(keys, options);
    const CubicPath first = morph.at(0.0)[0];
    const CubicPath last = morph.at(1.0)[0];
    ASSERT_EQ(first.segment_count(), last.segment_count());
    EXPECT_NEAR(signed_area(first), signed_area(last), 1e-6 * std::fabs(signed_area(first)));
    for (std::size_t i = 0; i < last.control_points().size(); i += 3) {
      const auto p = last.control_points()[i];
      EXPECT_LE(distance_from(first, p), 2e-3) << i;  // of an extent of 10; as dense as the samples are
    }
  }
}

}  // namespace
}  // namespace tandem
