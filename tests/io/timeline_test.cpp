#include "io/timeline.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <vector>

#include "tandem/error.h"

namespace tandem {
namespace {

double coordinate(double p, double q, double t) {
  return 3 * p * t * (1 - t) * (1 - t) + 3 * q * t * t * (1 - t) + t * t * t;
}

// The share of the way at the share of time x, by bisection.
double eased(const Easing& easing, double x) {
  double lo = 0.0;
  double hi = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (lo + hi) / 2;
    (coordinate(easing.x1, easing.x2, middle) < x ? lo : hi) = middle;
  }
  return coordinate(easing.y1, easing.y2, (lo + hi) / 2);
}

KeyFrames frames_at(std::vector<double> times, std::vector<std::size_t> keys) {
  KeyFrames frames;
  frames.times = std::move(times);
  frames.keys = std::move(keys);
  return frames;
}

// s at the share of time x of the timeline.
double played(const KeyFrames& frames, const std::vector<TimelineStep>& steps, double x) {
  std::size_t i = 0;
  while (i + 2 < steps.size() && steps[i + 1].time <= x) ++i;
  const double local = (x - steps[i].time) / (steps[i + 1].time - steps[i].time);
  const double share = eased(steps[i].easing, local);
  return (1 - share) * frames.times[steps[i].frame] + share * frames.times[steps[i + 1].frame];
}

TEST(Easing, ReadsNamesAndNumbers) {
  EXPECT_TRUE(parse_easing("linear").linear());
  EXPECT_EQ(parse_easing("ease-in-out").x2, 0.58);
  EXPECT_EQ(parse_easing(" 0.1, 0.2 0.3,0.4 ").y2, 0.4);
  for (const char* bad : {"", "0 0 1", "0 0 1 1 1", "0 0 1 1.5", "-0.1 0 1 1", "0 0 1 x", "0 0 nan 1",
                          "0x 0 1 1", "0.1.2 0 1"}) {
    EXPECT_THROW((void)parse_easing(bad), InvalidArgument) << bad;
  }
}

TEST(Easing, WholePartsAreTheEasingItself) {
  const Easing ease = parse_easing("ease");
  const EasingPart whole = part_of(ease, 0.0, 1.0);
  EXPECT_EQ(whole.start, 0.0);
  EXPECT_EQ(whole.easing.x1, ease.x1);
  EXPECT_EQ(whole.easing.y1, ease.y1);
  EXPECT_EQ(whole.easing.x2, ease.x2);
  EXPECT_EQ(whole.easing.y2, ease.y2);
}

// Frames between two keys must not be noticed: at every moment the same s as without them.
TEST(Timeline, FramesBetweenKeysShareTheEasing) {
  EXPECT_TRUE(rc::check([] {
    const auto number = [] { return *rc::gen::inRange(5, 96) / 100.0; };
    // Controls that stay in their order keep those of all parts within [0,1].
    const double x1 = number();
    const double y1 = number();
    const double x2 = *rc::gen::inRange(static_cast<int>(x1 * 100), 100) / 100.0;
    const double y2 = *rc::gen::inRange(static_cast<int>(y1 * 100), 100) / 100.0;
    const AnimationOptions options{.easing = fmt::format("{} {} {} {}", x1, y1, x2, y2)};
    const KeyFrames keys = frames_at({0, 0.4, 1}, {0, 1, 2});
    const KeyFrames more = frames_at({0, 0.1, 0.2, 0.4, 0.55, 0.7, 0.85, 1}, {0, 3, 7});
    const std::vector<TimelineStep> plain = forward_timeline(keys, options);
    const std::vector<TimelineStep> fine = forward_timeline(more, options);
    RC_ASSERT(fine.size() == 8u);
    for (int i = 0; i <= 100; ++i) {
      RC_ASSERT(std::fabs(played(keys, plain, i / 100.0) - played(more, fine, i / 100.0)) <= 1e-9);
    }
  }));
}

TEST(Timeline, EveryStepMayHaveItsOwnEasing) {
  const KeyFrames frames = frames_at({0, 0.1, 0.3, 0.8, 1}, {0, 2, 4});
  const std::vector<TimelineStep> steps = forward_timeline(frames, {.easing = "ease-in ; 0 0 0.58 1"});
  const Easing first = parse_easing("ease-in");
  const Easing second = parse_easing("ease-out");
  for (const double x : {0.0, 0.05, 0.2, 0.3, 0.5, 0.95, 1.0}) {
    const double wanted = x < 0.3 ? 0.3 * eased(first, x / 0.3) : 0.3 + 0.7 * eased(second, (x - 0.3) / 0.7);
    EXPECT_NEAR(played(frames, steps, x), wanted, 1e-9) << x;
  }
  for (const char* bad : {"linear;linear;linear", "linear;", ";", "linear;fast"}) {
    EXPECT_THROW((void)forward_timeline(frames, {.easing = bad}), InvalidArgument) << bad;
  }
}

TEST(Timeline, OneEasingTimesTheWholeOfASmoothMotion) {
  KeyFrames frames = frames_at({0, 0.1, 0.3, 0.8, 1}, {0, 2, 4});
  frames.smooth = true;
  const Easing easing = parse_easing("ease-in-out");
  const std::vector<TimelineStep> steps = forward_timeline(frames, {.easing = "ease-in-out"});
  for (const double x : {0.0, 0.05, 0.2, 0.3, 0.5, 0.95, 1.0}) {
    EXPECT_NEAR(played(frames, steps, x), eased(easing, x), 1e-9) << x;
  }
  // One for every step is what it says.
  const std::vector<TimelineStep> each = forward_timeline(frames, {.easing = "ease-in-out;ease-in-out"});
  EXPECT_NEAR(played(frames, each, 0.3), 0.3, 1e-9);
}

TEST(Timeline, KeepsControlsWithinBounds) {
  // Stands still for a moment in the middle: the one curve whose parts have controls beyond their ends.
  const AnimationOptions standing{.easing = "1 0 0 1"};
  const KeyFrames frames = frames_at({0, 0.03, 0.1, 0.5, 0.9, 1}, {0, 5});
  for (const TimelineStep& step : forward_timeline(frames, standing)) {
    for (const double x : {step.easing.x1, step.easing.y1, step.easing.x2, step.easing.y2}) {
      EXPECT_GE(x, 0.0);
      EXPECT_LE(x, 1.0);
    }
  }
}

TEST(Timeline, RunsBackAsItCame) {
  const KeyFrames frames = frames_at({0, 0.25, 0.5, 1}, {0, 2, 3});
  const AnimationOptions options{.duration = 3.0, .easing = "0.1 0.2 0.5 1"};
  const std::vector<TimelineStep> steps = loop_timeline(frames, options);
  ASSERT_EQ(steps.size(), 7u);
  EXPECT_EQ(loop_seconds(options), 6.0);
  for (const double x : {0.01, 0.1, 0.2, 0.3, 0.45, 0.5}) {
    EXPECT_NEAR(played(frames, steps, x), played(frames, steps, 1 - x), 1e-9) << x;
  }
  const AnimationOptions there{.duration = 3.0, .easing = "0.1 0.2 0.5 1", .alternate = false};
  const std::vector<TimelineStep> once = loop_timeline(frames, there);
  ASSERT_EQ(once.size(), 4u);
  EXPECT_EQ(loop_seconds(there), 3.0);
  EXPECT_NEAR(played(frames, steps, 0.2), played(frames, once, 0.4), 1e-9);
}

}  // namespace
}  // namespace tandem
