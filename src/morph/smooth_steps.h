#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "morph/step_blend.h"
#include "tandem/morph/path_morph.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// How a smooth morph goes through its steps (PathMorph): the steps' own blends, as the frame sees them, and
/// the poses of the frame, both with corrections of their velocities at the keys. A loop, whose last key is
/// its first one, runs through it at one velocity as well.
class SmoothSteps {
 public:
  /// blends: of the steps, in order, without detours. times: of the keys. poses: of the keys, about their
  /// centres, whether the frame turns or not.
  SmoothSteps(std::span<const StepBlend> blends, std::span<const double> times, std::vector<FramePose> poses);

  /// Slows keys down until no step has more in-betweens that cross or fold than without corrections, nor
  /// an outline that collapses or is turned inside out.
  /// blends: the same, with their detours.
  void find_pace(std::span<const StepBlend> blends);
  [[nodiscard]] const std::vector<double>& pace() const noexcept { return pace_; }

  /// Coordinates of a contour's control points on the way of step `step`, local in [0,1] or beyond.
  void at(const StepBlend& blend, std::size_t step, double local, std::size_t contour,
          std::span<double> points) const;
  [[nodiscard]] FramePose pose_at(std::size_t step, double local) const;

 private:
  /// What is added to the velocities at both ends of a step, per step and not per unit of s.
  struct Bend {
    std::vector<double> start;
    std::vector<double> end;
  };
  /// The pose that runs evenly, as the blends have it.
  [[nodiscard]] FramePose even_pose(std::size_t step, double local) const;
  /// Velocity of a contour as the frame sees it, at the start (end: at the end) of a step.
  [[nodiscard]] std::vector<double> velocity(const StepBlend& blend, std::size_t step, std::size_t contour,
                                             bool end) const;
  /// Sets what meets at the key between `step` and `next`, from the velocities of the steps that meet there.
  void join(std::span<const StepBlend> blends, std::size_t step, std::size_t next);
  void bend_contour(std::span<const StepBlend> blends, std::size_t step, std::size_t next,
                    std::size_t contour);
  /// Whether the last key is the first one again, with its joints where they were.
  [[nodiscard]] bool is_loop(std::span<const StepBlend> blends) const;
  /// What the in-betweens of a step are worth.
  struct Verdict {
    std::size_t faulty = 0;  ///< that cross or fold
    /// Per closed contour, wound as it is in the keys; infinite for open ones.
    std::vector<double> least_areas;
  };
  [[nodiscard]] Verdict judge(const StepBlend& blend, std::size_t step, bool smooth,
                              std::size_t most_faulty) const;
  [[nodiscard]] bool is_worse(const StepBlend& blend, std::size_t step) const;

  std::vector<double> lengths_;  ///< of the steps, in s
  std::vector<FramePose> poses_;
  std::vector<FramePose> pose_starts_;  ///< Bend of the pose, per step
  std::vector<FramePose> pose_ends_;
  std::vector<std::vector<Bend>> bends_;  ///< [step][contour]
  bool loop_ = false;
  std::vector<double> pace_;                   ///< per key
  std::vector<std::vector<double>> windings_;  ///< [step][contour]: 1 or -1, as the keys are wound
  std::vector<std::vector<double>> sizes_;     ///< [step][contour]: areas of both keys
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
