#include "io/timeline.h"

#include <fmt/format.h>

#include <cmath>

#include "io/number.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

std::vector<std::size_t> eased_stretches(const KeyFrames& frames, const std::vector<Easing>& easings) {
  if (frames.smooth && easings.size() == 1) return {0, frames.times.size() - 1};
  return frames.keys;
}

std::string format_easings(const std::vector<Easing>& easings) {
  std::string text;
  for (const Easing& easing : easings) {
    text += fmt::format("{}[{},{},{},{}]", text.empty() ? "" : ",", format_number(easing.x1),
                        format_number(easing.y1), format_number(easing.x2), format_number(easing.y2));
  }
  return text;
}

std::vector<TimelineStep> forward_timeline(const KeyFrames& frames, const AnimationOptions& options) {
  const std::vector<Easing> easings = parse_easings(options.easing, frames.keys.size() - 1);
  const std::vector<std::size_t> ends = eased_stretches(frames, easings);
  std::vector<TimelineStep> steps(frames.times.size());
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const Easing& easing = easings.size() == 1 ? easings.front() : easings[k];
    const std::size_t first = ends[k];
    const std::size_t last = ends[k + 1];
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
  std::vector<TimelineStep> steps = forward_timeline(frames, options);
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

KeyFrames keys_of(const KeyFrames& frames) {
  KeyFrames keys;
  keys.smooth = frames.smooth;
  for (const std::size_t key : frames.keys) {
    keys.keys.push_back(keys.times.size());
    keys.times.push_back(frames.times[key]);
  }
  return keys;
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
}

}  // namespace v0
}  // namespace tandem
