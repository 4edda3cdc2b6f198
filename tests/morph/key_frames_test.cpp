#include "tandem/morph/key_frames.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "morph/test_shapes.h"
#include "tandem/error.h"
#include "tandem/shape/transform.h"

namespace tandem {
namespace {

using test::any_outline;
using test::one;

MorphOptions quick(std::optional<bool> rotate) {
  MorphOptions options;
  options.match.samples = {24, 24};
  options.match.rotate = rotate;
  options.blend = BlendKind::affine;
  return options;
}

CubicPath line_to(double x, double y) {
  return CubicPath(Points({{0, 0}, {x / 3, y / 3}, {2 * x / 3, 2 * y / 3}, {x, y}}));
}

// The end runs along an arc of radius 1: the chord of an angle leaves it by its versine.
std::vector<CubicPath> arc(double s, double degrees) {
  const double angle = s * degrees / 180 * std::numbers::pi;
  return {line_to(std::cos(angle), std::sin(angle))};
}

// Linear blend of the frames at s, placed by their poses.
std::vector<Point> blended(const KeyFrames& frames, double s) {
  std::size_t i = 0;
  while (i + 2 < frames.times.size() && frames.times[i + 1] < s) ++i;
  const double local = (s - frames.times[i]) / (frames.times[i + 1] - frames.times[i]);
  std::vector<Point> points;
  for (std::size_t c = 0; c < frames.paths[i].size(); ++c) {
    const Points& a = frames.paths[i][c].control_points();
    const Points& b = frames.paths[i + 1][c].control_points();
    for (std::size_t k = 0; k < a.size(); ++k) {
      Vec2 p{(1 - local) * a[k][0] + local * b[k][0], (1 - local) * a[k][1] + local * b[k][1]};
      if (!frames.poses.empty()) {
        const FramePose& from = frames.poses[i];
        const FramePose& to = frames.poses[i + 1];
        p = Transform::rotate_degrees((1 - local) * from.degrees + local * to.degrees)(p);
        p.x += (1 - local) * from.center.x + local * to.center.x;
        p.y += (1 - local) * from.center.y + local * to.center.y;
      }
      points.push_back({p.x, p.y});
    }
  }
  return points;
}

double worst(const KeyFrames& frames, const Motion& motion) {
  double largest = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double s = i / 1000.0;
    const std::vector<Point> points = blended(frames, s);
    std::size_t at = 0;
    for (const CubicPath& path : motion(s)) {
      for (std::size_t k = 0; k < path.control_points().size(); ++k) {
        const auto p = path.control_points()[k];
        largest = std::max(largest, test::apart(points[at++], {p[0], p[1]}));
      }
    }
  }
  return largest / frames.box.diagonal();
}

TEST(KeyFrames, AffineMorphsNeedTheirKeysOnly) {
  EXPECT_TRUE(rc::check([] {
    std::vector<Shape> keys;
    const int count = *rc::gen::inRange(2, 5);
    for (int i = 0; i < count; ++i) keys.push_back(one(any_outline()));
    const PathMorph morph(keys, quick(false));
    const KeyFrames frames = key_frames(morph);
    RC_ASSERT(frames.times.size() == keys.size());
    RC_ASSERT(frames.poses.empty());
    RC_ASSERT(frames.max_error <= 1e-12);
    for (std::size_t key = 0; key < keys.size(); ++key) {
      RC_ASSERT(frames.keys[key] == key);
      RC_ASSERT(frames.paths[key][0] == morph.contours()[0].keys[key]);
    }
    RC_ASSERT(frames.lines[0] == morph.contours()[0].lines);
  }));
}

TEST(KeyFrames, TurningMorphsAreBakedOrKeepTheirPoses) {
  EXPECT_TRUE(rc::check([] {
    const Curve first = any_outline();
    const double degrees = *rc::gen::element(60.0, 90.0, 150.0);
    const Transform map = Transform::translate(7, -3) * Transform::rotate_degrees(degrees);
    const std::vector<Shape> keys{one(first), one(transform(first, map)), one(any_outline())};
    const PathMorph morph(keys, quick(true));
    const Motion motion = [&](double s) { return morph.at(s); };
    const KeyFrames seen = key_frames(morph, {.bake_turn = false});
    RC_ASSERT(seen.times.size() == 3u);
    RC_ASSERT(seen.poses.empty() != morph.turns());
    RC_ASSERT(worst(seen, motion) <= 1e-12);
    const KeyFrames baked = key_frames(morph);
    RC_ASSERT(baked.poses.empty());
    RC_ASSERT(!morph.turns() || baked.times.size() > 3u);
    RC_ASSERT(baked.max_error <= 1e-3);
    RC_ASSERT(worst(baked, motion) <= 1.05e-3);
  }));
}

TEST(KeyFrames, TakeAsManyFramesAsAnArcNeeds) {
  for (const double degrees : {1.0, 20.0, 90.0, 360.0}) {
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
      const Motion motion = [&](double s) { return arc(s, degrees); };
      const std::vector<double> ends{0, 1};
      const KeyFrames frames = key_frames(motion, ends, {.tolerance = tolerance});
      const auto versine = [&](double count) {
        return (1 - std::cos(degrees / 360 * std::numbers::pi / count)) / frames.box.diagonal();
      };
      const auto count = static_cast<double>(frames.times.size() - 1);
      EXPECT_LE(frames.max_error, tolerance);
      // Hardly more than the fewest: steps are found within a sixteenth.
      const double fewest =
          std::ceil(degrees / 360 * std::numbers::pi / std::acos(1 - tolerance * frames.box.diagonal()));
      EXPECT_GE(count, fewest) << degrees << ' ' << tolerance;
      EXPECT_LE(count, std::ceil(fewest * 17 / 16)) << degrees << ' ' << tolerance;
      EXPECT_LE(versine(count), frames.max_error + 1e-12);
    }
  }
}

TEST(KeyFrames, FindMotionsThatCancelOutInTheMiddle) {
  // To one side, and as far to the other: the middle lies on the straight way.
  const Motion motion = [](double s) {
    return std::vector<CubicPath>{line_to(10 + s, std::sin(2 * std::numbers::pi * s))};
  };
  const std::vector<double> ends{0, 1};
  const KeyFrames frames = key_frames(motion, ends);
  EXPECT_GT(frames.times.size(), 8u);
  EXPECT_LE(worst(frames, motion), 1.05e-3);
}

TEST(KeyFrames, HoldKeysOfUnevenTimes) {
  // Still until 0.8, then a quarter turn.
  const Motion motion = [](double s) { return arc(s < 0.8 ? 0.0 : (s - 0.8) / 0.2, 90.0); };
  const std::vector<double> times{0, 0.8, 1};
  const KeyFrames frames = key_frames(motion, times);
  ASSERT_EQ(frames.keys.size(), 3u);
  EXPECT_EQ(frames.keys[1], 1u);
  EXPECT_EQ(frames.times[1], 0.8);
  EXPECT_EQ(frames.keys[2], frames.times.size() - 1);
  EXPECT_EQ(frames.times.back(), 1.0);
  EXPECT_TRUE(std::is_sorted(frames.times.begin(), frames.times.end()));
  EXPECT_LE(worst(frames, motion), 1.05e-3);
  EXPECT_GT(frames.times.size(), 6u);
}

TEST(KeyFrames, EndWhereAMotionJumps) {
  const Motion motion = [](double s) { return std::vector<CubicPath>{line_to(s < 0.3 ? 1 : 2, 0)}; };
  const std::vector<double> ends{0, 1};
  const KeyFrames frames = key_frames(motion, ends);
  EXPECT_LE(frames.times.size(), 12u + 1u);
  EXPECT_GT(frames.max_error, 0.1);  // and it says so
}

TEST(KeyFrames, RejectNonsense) {
  const Motion motion = [](double s) { return arc(s, 90.0); };
  const auto with = [&](std::vector<double> times, double tolerance) {
    return key_frames(motion, times, {.tolerance = tolerance});
  };
  EXPECT_THROW((void)with({0, 1}, 0.0), InvalidArgument);
  EXPECT_THROW((void)with({0, 1}, std::nan("")), InvalidArgument);
  for (const std::vector<double>& times :
       {std::vector<double>{}, {0.0}, {0.0, 0.5}, {0.1, 1.0}, {0.0, 0.6, 0.6, 1.0}, {0.0, 2.0, 1.0}}) {
    EXPECT_THROW((void)with(times, 1e-3), InvalidArgument);
  }
  const Motion changing = [](double s) {
    return std::vector<CubicPath>(s < 0.5 ? 1 : 2, line_to(1 + s, s * s));
  };
  const std::vector<double> ends{0, 1};
  EXPECT_THROW((void)key_frames(changing, ends), InvalidArgument);
}

}  // namespace
}  // namespace tandem
