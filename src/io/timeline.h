#pragma once

#include <cstddef>
#include <vector>

#include "io/easing.h"
#include "tandem/io/animation.h"
#include "tandem/morph/key_frames.h"

namespace tandem {
inline namespace v0 {

/// A frame, when it is reached, and how its motion to the next step is timed.
struct TimelineStep {
  std::size_t frame = 0;
  double time = 0.0;  ///< share of the timeline, in [0,1]
  Easing easing;      ///< of the last step: linear
};

/// The way from the first frame to the last; the easing runs from key to key, so that frames between two keys
/// share it.
[[nodiscard]] std::vector<TimelineStep> forward_timeline(const KeyFrames& frames, const Easing& easing);

/// The same way there and, where options.alternate, back.
[[nodiscard]] std::vector<TimelineStep> loop_timeline(const KeyFrames& frames,
                                                      const AnimationOptions& options);

/// s at the share of time x in [0,1].
[[nodiscard]] double played_at(const KeyFrames& frames, const std::vector<TimelineStep>& steps, double x);

/// Seconds that loop_timeline() takes.
[[nodiscard]] double loop_seconds(const AnimationOptions& options);

/// @throws InvalidArgument duration <= 0, or no such easing
void check_animation(const AnimationOptions& options);

}  // namespace v0
}  // namespace tandem
