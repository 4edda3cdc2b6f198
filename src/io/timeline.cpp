#include "io/timeline.h"

#include <fmt/format.h>

#include <cmath>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

std::vector<TimelineStep> forward_timeline(const KeyFrames& frames, const Easing& easing) {
  std::vector<TimelineStep> steps(frames.times.size());
  for (std::size_t key = 0; key + 1 < frames.keys.size(); ++key) {
    const std::size_t first = frames.keys[key];
    const std::size_t last = frames.keys[key + 1];
    const double start = frames.times[first];
    const double length = frames.times[last] - start;
    for (std::size_t i = first; i < last; ++i) {
      const EasingPart part = part_of(easing, (frames.times[i] - start) / length,
                                      i + 1 == last ? 1.0 : (frames.times[i + 1] - start) / length);
      steps[i] = {i, start + part.start * length, part.easing};
    }
  }
  steps.back() = {steps.size() - 1, 1.0, {}};
  return steps;
}

std::vector<TimelineStep> loop_timeline(const KeyFrames& frames, const AnimationOptions& options) {
  std::vector<TimelineStep> steps = forward_timeline(frames, parse_easing(options.easing));
  if (!options.alternate) return steps;
  const std::size_t count = steps.size();
  for (TimelineStep& step : steps) step.time *= 0.5;
  for (std::size_t i = count - 1; i-- > 0;) {
    // The same motion runs backwards, so its curve is turned round.
    steps.back().easing = reversed(steps[i].easing);
    steps.push_back({steps[i].frame, 1.0 - steps[i].time, {}});
  }
  return steps;
}

double played_at(const KeyFrames& frames, const std::vector<TimelineStep>& steps, double x) {
  std::size_t i = steps.size() - 2;
  while (i > 0 && steps[i].time > x) --i;
  const double share = ease(steps[i].easing, (x - steps[i].time) / (steps[i + 1].time - steps[i].time));
  return (1.0 - share) * frames.times[steps[i].frame] + share * frames.times[steps[i + 1].frame];
}

double loop_seconds(const AnimationOptions& options) {
  return options.alternate ? 2.0 * options.duration : options.duration;
}

void check_animation(const AnimationOptions& options) {
  if (!(options.duration > 0.0 && std::isfinite(options.duration))) {
    throw InvalidArgument(fmt::format("animation: duration is {} s, expected > 0", options.duration));
  }
  (void)parse_easing(options.easing);
}

}  // namespace v0
}  // namespace tandem
