#include "tandem/morph/key_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
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
};

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

double blend_error(const Frame& a, const Frame& b, const Frame& between) {
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
  return largest;
}

/// Frames of a motion; `tolerance` and `error` are absolute.
class Stepping {
 public:
  Stepping(const Motion& motion, double tolerance) : motion_(motion), tolerance_(tolerance) {}

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
    Frame frame{s, motion_(s)};
    check_same_segments(like.paths, frame.paths, s);
    return frame;
  }

  [[nodiscard]] double error_at(const Frame& a, const Frame& b, double share) const {
    return blend_error(a, b, frame_at((1.0 - share) * a.s + share * b.s, a));
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

  const Motion& motion_;
  double tolerance_;
  double error_ = 0.0;
};

void check(std::span<const double> key_times, const KeyFrameOptions& options) {
  if (!(options.tolerance > 0.0)) {
    throw InvalidArgument(fmt::format("key frames: the tolerance is {}, expected > 0", options.tolerance));
  }
  const bool rising = key_times.size() >= 2 && key_times.front() == 0.0 && key_times.back() == 1.0 &&
                      std::adjacent_find(key_times.begin(), key_times.end(),
                                         [](double a, double b) { return !(a < b); }) == key_times.end();
  if (!rising) {
    throw InvalidArgument(
        fmt::format("key frames: the times of the keys are {}, expected to rise from 0 to 1",
                    fmt::join(key_times, ", ")));
  }
}

/// keys: the motion at the key times. The tolerance is a share of `box`.
KeyFrames step_through(const Motion& motion, std::span<const double> key_times, std::span<const Paths> keys,
                       Box box, double tolerance) {
  const double diagonal = box.diagonal();
  Stepping stepping(motion, tolerance * diagonal);
  std::vector<Frame> frames{{key_times.front(), keys.front()}};
  KeyFrames result;
  result.keys.push_back(0);
  for (std::size_t key = 0; key + 1 < key_times.size(); ++key) {
    stepping.go_on({key_times[key + 1], keys[key + 1]}, frames);
    result.keys.push_back(frames.size() - 1);
  }
  for (Frame& frame : frames) {
    result.times.push_back(frame.s);
    result.paths.push_back(std::move(frame.paths));
  }
  result.max_error = diagonal > 0.0 ? stepping.error() / diagonal : 0.0;
  result.box = std::move(box);
  return result;
}

FramePose blend(const FramePose& a, const FramePose& b, double local) {
  return {{(1.0 - local) * a.center.x + local * b.center.x, (1.0 - local) * a.center.y + local * b.center.y},
          (1.0 - local) * a.degrees + local * b.degrees};
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
  std::vector<double> key_times;
  for (std::size_t key = 0; key < morph.key_count(); ++key) {
    key_times.push_back(static_cast<double>(key) / static_cast<double>(morph.key_count() - 1));
  }
  check(key_times, options);
  const bool in_frame = morph.turns() && !options.bake_turn;
  const auto pose_at = [&](double s) {
    const KeyPosition at = locate_key(s, morph.key_count());
    return blend(morph.poses()[at.key], morph.poses()[at.key + 1], at.local);
  };
  const Motion motion = [&](double s) { return in_frame ? seen_from(pose_at(s), morph.at(s)) : morph.at(s); };
  std::vector<Paths> keys;
  for (std::size_t key = 0; key < morph.key_count(); ++key) {
    if (!in_frame) {
      keys.push_back(morph.at(key_times[key]));
      continue;
    }
    Paths& paths = keys.emplace_back();
    for (const PathContour& contour : morph.contours()) paths.push_back(contour.keys[key]);
  }
  KeyFrames result = step_through(motion, key_times, keys, morph.box(), options.tolerance);
  result.fill_rule = morph.fill_rule();
  for (const PathContour& contour : morph.contours()) result.lines.push_back(contour.lines);
  if (in_frame) {
    for (const double s : result.times) result.poses.push_back(pose_at(s));
  }
  return result;
}

KeyFrames key_frames(const Motion& motion, std::span<const double> key_times,
                     const KeyFrameOptions& options) {
  check(key_times, options);
  std::vector<Paths> keys;
  Box box;
  const auto include = [&](const Paths& paths) {
    for (const CubicPath& path : paths) box.include(bounding_box(to_curve(path)));
  };
  for (std::size_t key = 0; key < key_times.size(); ++key) {
    keys.push_back(motion(key_times[key]));
    check_same_segments(keys.front(), keys.back(), key_times[key]);
    include(keys.back());
    for (std::size_t i = 1; key > 0 && i < kBoxSamples; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(kBoxSamples);
      include(motion((1.0 - share) * key_times[key - 1] + share * key_times[key]));
    }
  }
  return step_through(motion, key_times, keys, std::move(box), options.tolerance);
}

}  // namespace v0
}  // namespace tandem
