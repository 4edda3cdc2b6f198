#pragma once

#include <cstddef>
#include <string>
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

/// Where easings begin and end: indices of frames, one more than there are stretches. The keys; of a smooth
/// motion with a single easing the first and the last.
[[nodiscard]] std::vector<std::size_t> eased_stretches(const KeyFrames& frames,
                                                       const std::vector<Easing>& easings);

/// "[x1,y1,x2,y2],...": as the scripts of pages read easings.
[[nodiscard]] std::string format_easings(const std::vector<Easing>& easings);

/// The way from the first frame to the last; frames between the ends of a stretch share its easing.
/// @throws InvalidArgument another number of easings than one, or one per step from key to key
[[nodiscard]] std::vector<TimelineStep> forward_timeline(const KeyFrames& frames,
                                                         const AnimationOptions& options);

/// The same way there and, where options.alternate, back.
[[nodiscard]] std::vector<TimelineStep> loop_timeline(const KeyFrames& frames,
                                                      const AnimationOptions& options);

/// The keys alone as frames, for what changes evenly from key to key.
[[nodiscard]] KeyFrames keys_of(const KeyFrames& frames);

/// s at the share of time x in [0,1].
[[nodiscard]] double played_at(const KeyFrames& frames, const std::vector<TimelineStep>& steps, double x);

/// Seconds that loop_timeline() takes.
[[nodiscard]] double loop_seconds(const AnimationOptions& options);

/// @throws InvalidArgument duration <= 0
void check_animation(const AnimationOptions& options);

}  // namespace v0
}  // namespace tandem
