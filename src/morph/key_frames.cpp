#include "tandem/morph/key_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include "shape/trigonometry.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

using Paths = std::vector<CubicPath>;

// Of the way from key to key: frames are no nearer to each other.
constexpr double kLeastStep = 1.0 / 1024.0;
// A step is found within this share of it: few frames more than the fewest, for few looks at the motion.
constexpr double kStepAccuracy = 1.0 / 16.0;
// Places between two frames at which the blend is compared: the middle first, where most blends are farthest
// off. It alone would take a motion for linear that swings to one side first and then to the other.
constexpr std::array<double, 7> kProbes = {0.5, 0.25, 0.75, 0.375, 0.625, 0.125, 0.875};
// In-betweens per pair of keys that the box of a motion is taken from beside its frames.
constexpr std::size_t kBoxSamples = 16;

struct Frame {
  double s = 0.0;
  Paths paths;
  FramePose pose = {};  ///< none: all of them alike
};

/// What is stepped through.
using FrameMotion = std::function<Frame(double s)>;

void check_same_segments(const Paths& first, const Paths& paths, double s) {
  bool same = paths.size() == first.size();
  for (std::size_t i = 0; same && i < paths.size(); ++i) {
    same = paths[i].control_points().data().size() == first[i].control_points().data().size();
  }
  if (!same) {
    throw InvalidArgument(
        fmt::format("key frames: the segments at s = {} are others than at s = 0, expected the same", s));
  }
}

// How far the pose that runs evenly carries points off that are no farther from the centre than `radius`.
double pose_error(const FramePose& a, const FramePose& b, const FramePose& between, double local,
                  double radius) {
  const double x = (1.0 - local) * a.center.x + local * b.center.x - between.center.x;
  const double y = (1.0 - local) * a.center.y + local * b.center.y - between.center.y;
  const double degrees = (1.0 - local) * a.degrees + local * b.degrees - between.degrees;
  return std::sqrt(x * x + y * y) + radius * std::fabs(degrees) * std::numbers::pi / 180.0;
}

double blend_error(const Frame& a, const Frame& b, const Frame& between, double radius) {
  const double local = (between.s - a.s) / (b.s - a.s);
  double largest = 0.0;
  for (std::size_t i = 0; i < between.paths.size(); ++i) {
    const auto p = a.paths[i].control_points().data();
    const auto q = b.paths[i].control_points().data();
    const auto wanted = between.paths[i].control_points().data();
    for (std::size_t k = 0; k + 1 < wanted.size(); k += 2) {
      const double x = (1.0 - local) * p[k] + local * q[k] - wanted[k];
      const double y = (1.0 - local) * p[k + 1] + local * q[k + 1] - wanted[k + 1];
      largest = std::max({largest, std::fabs(x), std::fabs(y), std::sqrt(x * x + y * y)});
    }
  }
  return largest + pose_error(a.pose, b.pose, between.pose, local, radius);
}

/// Frames of a motion; `tolerance`, `radius` (of all that turns) and `error` are absolute.
class Stepping {
 public:
  Stepping(const FrameMotion& motion, double tolerance, double radius)
      : motion_(motion), tolerance_(tolerance), radius_(radius) {}

  /// Appends what is needed behind the last of `frames`, up to and with the key `last`.
  void go_on(const Frame& last, std::vector<Frame>& frames) {
    const double least = kLeastStep * (last.s - frames.back().s);
    while (!fits(frames.back(), last) && last.s - frames.back().s > least) {
      append(farthest(frames.back(), last.s, least), frames);
    }
    append(last, frames);
  }
  [[nodiscard]] double error() const noexcept { return error_; }

 private:
  [[nodiscard]] Frame frame_at(double s, const Frame& like) const {
    Frame frame = motion_(s);
    check_same_segments(like.paths, frame.paths, s);
    return frame;
  }

  [[nodiscard]] double error_at(const Frame& a, const Frame& b, double share) const {
    return blend_error(a, b, frame_at((1.0 - share) * a.s + share * b.s, a), radius_);
  }

  [[nodiscard]] bool fits(const Frame& a, const Frame& b) const {
    return std::all_of(kProbes.begin(), kProbes.end(),
                       [&](double share) { return error_at(a, b, share) <= tolerance_; });
  }

  /// The farthest frame up to which a blend fits, before `end`, up to which none does.
  [[nodiscard]] Frame farthest(const Frame& from, double end, double least) const {
    double lo = least;
    double hi = end - from.s;
    std::optional<Frame> found;
    while (hi > (1.0 + kStepAccuracy) * lo) {
      const double step = std::sqrt(lo * hi);
      Frame to = frame_at(from.s + step, from);
      if (fits(from, to)) {
        lo = step;
        found = std::move(to);
      } else {
        hi = step;
      }
    }
    return found ? *std::move(found) : frame_at(from.s + least, from);
  }

  void append(Frame frame, std::vector<Frame>& frames) {
    for (const double share : kProbes) error_ = std::max(error_, error_at(frames.back(), frame, share));
    frames.push_back(std::move(frame));
  }

  const FrameMotion& motion_;
  double tolerance_;
  double radius_;
  double error_ = 0.0;
};

void check(std::span<const double> key_times, const KeyFrameOptions& options) {
  if (!(options.tolerance > 0.0)) {
    throw InvalidArgument(fmt::format("key frames: the tolerance is {}, expected > 0", options.tolerance));
  }
  check_key_times(key_times);
}

/// keys: the motion at the keys. The tolerance is a share of `box`.
KeyFrames step_through(const FrameMotion& motion, std::vector<Frame> keys, Box box, double tolerance) {
  const double diagonal = box.diagonal();
  Stepping stepping(motion, tolerance * diagonal, 0.5 * diagonal);
  std::vector<Frame> frames{std::move(keys.front())};
  KeyFrames result;
  result.keys.push_back(0);
  for (std::size_t key = 1; key < keys.size(); ++key) {
    stepping.go_on(keys[key], frames);
    result.keys.push_back(frames.size() - 1);
  }
  for (Frame& frame : frames) {
    result.times.push_back(frame.s);
    result.paths.push_back(std::move(frame.paths));
    result.poses.push_back(frame.pose);
  }
  result.max_error = diagonal > 0.0 ? stepping.error() / diagonal : 0.0;
  result.box = std::move(box);
  return result;
}

/// Paths that are drawn in this pose, as the frame sees them.
Paths seen_from(const FramePose& pose, const Paths& paths) {
  const CosSin back = cos_sin_degrees(-pose.degrees);
  Paths seen;
  seen.reserve(paths.size());
  for (const CubicPath& path : paths) {
    Points points = path.control_points();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto p = points[i];
      const double x = p[0] - pose.center.x;
      const double y = p[1] - pose.center.y;
      p[0] = back.cosine * x - back.sine * y;
      p[1] = back.sine * x + back.cosine * y;
    }
    seen.emplace_back(std::move(points), path.is_closed());
  }
  return seen;
}

}  // namespace

KeyFrames key_frames(const PathMorph& morph, const KeyFrameOptions& options) {
  check(morph.key_times(), options);
  const bool in_frame = morph.turns() && !options.bake_turn;
  const FrameMotion motion = [&](double s) {
    if (!in_frame) return Frame{s, morph.at(s)};
    const FramePose pose = morph.pose_at(s);
    return Frame{s, seen_from(pose, morph.at(s)), pose};
  };
  std::vector<Frame> keys;
  for (std::size_t key = 0; key < morph.key_count(); ++key) {
    const double s = morph.key_times()[key];
    if (!in_frame) {
      keys.push_back(motion(s));
      continue;
    }
    Frame& frame = keys.emplace_back(Frame{s, {}, morph.pose_at(s)});
    for (const PathContour& contour : morph.contours()) frame.paths.push_back(contour.keys[key]);
  }
  KeyFrames result = step_through(motion, std::move(keys), morph.box(), options.tolerance);
  result.fill_rule = morph.fill_rule();
  result.smooth = morph.is_smooth();
  for (const PathContour& contour : morph.contours()) result.lines.push_back(contour.lines);
  if (!in_frame) result.poses.clear();
  return result;
}

KeyFrames key_frames(const Motion& motion, std::span<const double> key_times,
                     const KeyFrameOptions& options) {
  check(key_times, options);
  std::vector<Frame> keys;
  Box box;
  const auto include = [&](const Paths& paths) {
    for (const CubicPath& path : paths) box.include(bounding_box(to_curve(path)));
  };
  for (std::size_t key = 0; key < key_times.size(); ++key) {
    keys.push_back({key_times[key], motion(key_times[key])});
    check_same_segments(keys.front().paths, keys.back().paths, key_times[key]);
    include(keys.back().paths);
    for (std::size_t i = 1; key > 0 && i < kBoxSamples; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(kBoxSamples);
      include(motion((1.0 - share) * key_times[key - 1] + share * key_times[key]));
    }
  }
  const FrameMotion frames = [&](double s) { return Frame{s, motion(s)}; };
  KeyFrames result = step_through(frames, std::move(keys), std::move(box), options.tolerance);
  result.poses.clear();
  return result;
}

}  // namespace v0
}  // namespace tandem
