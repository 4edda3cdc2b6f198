#include "morph/smooth_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "morph/hermite_functions.h"
#include "morph/measures.h"
#include "shape/trigonometry.h"
#include "tandem/morph/quality.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// A contour whose points all lie within this share of its extent elsewhere is a point: collapsed ones are so
// up to rounding.
constexpr double kPoint = 1e-9;
// An outline that shrinks to less than this share of what the plain step leaves of its area collapses; one
// that is turned inside out has less than nothing.
constexpr double kLeastArea = 0.5;
// Points of the last key that lie within this share of the shape's extent of those of the first are the same:
// each step leaves joints where they are up to the tolerance of its fit, a thousandth of the outline's
// length.
constexpr double kSameKey = 0.02;
constexpr double kFullTurn = 360.0;
constexpr double kSameTurn = 1e-6;  // degrees; turns are summed up
// Shares of the speed at which keys are tried to be passed.
constexpr std::array<double, 4> kPaces = {1.0, 0.5, 0.25, 0.0};

FramePose sum(double f, const FramePose& a, double g, const FramePose& b) {
  return {{f * a.center.x + g * b.center.x, f * a.center.y + g * b.center.y}, f * a.degrees + g * b.degrees};
}

// Points drawn in a pose, as the frame sees them; and the other way.
void see(const FramePose& pose, std::span<double> points) {
  const CosSin turn = cos_sin_degrees(-pose.degrees);
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
    const double x = points[i] - pose.center.x;
    const double y = points[i + 1] - pose.center.y;
    points[i] = turn.cosine * x - turn.sine * y;
    points[i + 1] = turn.sine * x + turn.cosine * y;
  }
}
void place(const FramePose& pose, std::span<double> points) {
  const CosSin turn = cos_sin_degrees(pose.degrees);
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
    const double x = points[i];
    const double y = points[i + 1];
    points[i] = turn.cosine * x - turn.sine * y + pose.center.x;
    points[i + 1] = turn.sine * x + turn.cosine * y + pose.center.y;
  }
}

double extent(std::span<const double> points) {
  double largest = 0.0;
  for (std::size_t i = 2; i < points.size(); ++i) {
    largest = std::max(largest, std::fabs(points[i] - points[i % 2]));
  }
  return largest;
}

double extent_at(const StepBlend& blend, double local, std::size_t contour) {
  std::vector<double> points(blend.size(contour));
  blend.at(local, contour, points);
  return extent(points);
}

double area_at(const StepBlend& blend, double local, std::size_t contour) {
  std::vector<double> points(blend.size(contour));
  blend.at(local, contour, points);
  return signed_area(points);
}

// A point has nothing that could deform before it is born or after it has died: it moves as one.
void make_even(std::span<double> velocity) {
  Vec2 mean{};
  const double share = 2.0 / static_cast<double>(velocity.size());
  for (std::size_t i = 0; i + 1 < velocity.size(); i += 2) {
    mean.x += share * velocity[i];
    mean.y += share * velocity[i + 1];
  }
  for (std::size_t i = 0; i + 1 < velocity.size(); i += 2) {
    velocity[i] = mean.x;
    velocity[i + 1] = mean.y;
  }
}

}  // namespace

SmoothSteps::SmoothSteps(std::span<const StepBlend> blends, std::span<const double> times,
                         std::vector<FramePose> poses)
    : poses_(std::move(poses)),
      pose_starts_(blends.size()),
      pose_ends_(blends.size()),
      bends_(blends.size(), std::vector<Bend>(blends.front().contour_count())),
      pace_(times.size(), 1.0) {
  for (std::size_t k = 0; k < blends.size(); ++k) lengths_.push_back(times[k + 1] - times[k]);
  for (std::size_t k = 0; k < blends.size(); ++k) {
    for (std::size_t c = 0; c < bends_[k].size(); ++c) {
      bends_[k][c].start.resize(blends[k].size(c));
      bends_[k][c].end.resize(blends[k].size(c));
    }
  }
  for (std::size_t k = 0; k + 1 < blends.size(); ++k) join(blends, k, k + 1);
  loop_ = is_loop(blends);
  if (loop_) join(blends, blends.size() - 1, 0);
}

void SmoothSteps::join(std::span<const StepBlend> blends, std::size_t step, std::size_t next) {
  const FramePose before = sum(1.0, poses_[step + 1], -1.0, poses_[step]);
  const FramePose after = sum(1.0, poses_[next + 1], -1.0, poses_[next]);
  const KeyVelocity share(lengths_[step], lengths_[next]);
  const FramePose velocity = sum(share.before, before, share.after, after);
  pose_ends_[step] = sum(lengths_[step], velocity, -1.0, before);
  pose_starts_[next] = sum(lengths_[next], velocity, -1.0, after);
  for (std::size_t c = 0; c < bends_[step].size(); ++c) bend_contour(blends, step, next, c);
}

bool SmoothSteps::is_loop(std::span<const StepBlend> blends) const {
  const FramePose change = sum(1.0, poses_.back(), -1.0, poses_.front());
  if (std::fabs(std::remainder(change.degrees, kFullTurn)) > kSameTurn) return false;
  double size = 0.0;
  for (std::size_t c = 0; c < blends.front().contour_count(); ++c) {
    size = std::max(size, extent_at(blends.front(), 0.0, c));
  }
  for (std::size_t c = 0; c < blends.front().contour_count(); ++c) {
    std::vector<double> first(blends.front().size(c));
    std::vector<double> last(blends.back().size(c));
    blends.front().at(0.0, c, first);
    blends.back().at(1.0, c, last);
    // What is a point at both ends is not seen there, wherever it is.
    if (std::max(extent(first), extent(last)) <= kPoint * size) continue;
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (!(std::fabs(last[i] - first[i]) <= kSameKey * size)) return false;
    }
  }
  return true;
}

void SmoothSteps::bend_contour(std::span<const StepBlend> blends, std::size_t step, std::size_t next,
                               std::size_t contour) {
  const std::vector<double> before = velocity(blends[step], step, contour, true);
  const std::vector<double> after = velocity(blends[next], next, contour, false);
  const KeyVelocity share(lengths_[step], lengths_[next]);
  std::vector<double> mean(before.size());
  for (std::size_t i = 0; i < mean.size(); ++i) {
    mean[i] = share.before * before[i] + share.after * after[i];
  }
  const double largest =
      std::max(extent_at(blends[step], 0.0, contour), extent_at(blends[next], 1.0, contour));
  if (extent_at(blends[step], 1.0, contour) <= kPoint * largest) make_even(mean);
  Bend& left = bends_[step][contour];
  Bend& right = bends_[next][contour];
  for (std::size_t i = 0; i < mean.size(); ++i) {
    left.end[i] = lengths_[step] * mean[i] - before[i];
    right.start[i] = lengths_[next] * mean[i] - after[i];
  }
}

FramePose SmoothSteps::even_pose(std::size_t step, double local) const {
  return sum(1.0 - local, poses_[step], local, poses_[step + 1]);
}

std::vector<double> SmoothSteps::velocity(const StepBlend& blend, std::size_t step, std::size_t contour,
                                          bool end) const {
  std::vector<double> velocity(blend.size(contour));
  std::vector<double> points(velocity.size());
  const double difference = end ? -kDifference : kDifference;
  for (std::size_t j = 0; j < kStencil.size(); ++j) {
    const double local = (end ? 1.0 : 0.0) + static_cast<double>(j) * difference;
    blend.at(local, contour, points);
    see(even_pose(step, local), points);
    for (std::size_t i = 0; i < points.size(); ++i) velocity[i] += kStencil[j] / difference * points[i];
  }
  return velocity;
}

void SmoothSteps::at(const StepBlend& blend, std::size_t step, double local, std::size_t contour,
                     std::span<double> points) const {
  // Beyond the keys it goes on as the step itself does; at the keys there is nothing to correct.
  if (local <= 0.0 || local >= 1.0) return blend.at(local, contour, points);
  const double first = pace_[step];
  const double last = pace_[step + 1];
  // Slower at a key, on the same way.
  const double warped = local + (first - 1.0) * at_start(local) + (last - 1.0) * at_end(local);
  blend.at(warped, contour, points);
  see(even_pose(step, warped), points);
  const Bend& bend = bends_[step][contour];
  const double f = first * at_start(local);
  const double g = last * at_end(local);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += f * bend.start[i] + g * bend.end[i];
  place(pose_at(step, local), points);
}

FramePose SmoothSteps::pose_at(std::size_t step, double local) const {
  const FramePose even = even_pose(step, local);
  if (local <= 0.0 || local >= 1.0) return even;
  return sum(1.0, even, 1.0, sum(at_start(local), pose_starts_[step], at_end(local), pose_ends_[step]));
}

SmoothSteps::Verdict SmoothSteps::judge(const StepBlend& blend, std::size_t step, bool smooth,
                                        std::size_t most_faulty) const {
  Verdict verdict;
  std::vector<std::vector<double>> points(blend.contour_count());
  std::vector<PathView> views(points.size());
  verdict.least_areas.assign(points.size(), std::numeric_limits<double>::infinity());
  const auto sampler = [&](double x) -> std::span<const PathView> {
    for (std::size_t c = 0; c < points.size(); ++c) {
      points[c].resize(blend.size(c));
      if (smooth) {
        at(blend, step, x, c, points[c]);
      } else {
        blend.at(x, c, points[c]);
      }
      views[c] = {points[c], blend.is_closed(c)};
      if (!blend.is_closed(c)) continue;
      const double area = signed_area(points[c]);
      verdict.least_areas[c] = std::min(verdict.least_areas[c], windings_[step][c] * area);
    }
    return views;
  };
  QualityOptions options;
  options.most_faulty = most_faulty;
  verdict.faulty = measure_quality(PathSampler(sampler), options).faulty;
  return verdict;
}

bool SmoothSteps::is_worse(const StepBlend& blend, std::size_t step) const {
  const Verdict plain = judge(blend, step, false, std::numeric_limits<std::size_t>::max());
  const Verdict now = judge(blend, step, true, plain.faulty);
  if (now.faulty > plain.faulty) return true;
  for (std::size_t c = 0; c < plain.least_areas.size(); ++c) {
    const double least = plain.least_areas[c];
    // Up to rounding, for those that are points at a key.
    if (least >= 0.0 && now.least_areas[c] < kLeastArea * least - kPoint * sizes_[step][c]) return true;
  }
  return false;
}

void SmoothSteps::find_pace(std::span<const StepBlend> blends) {
  for (std::size_t k = 0; k < blends.size(); ++k) {
    std::vector<double>& windings = windings_.emplace_back();
    std::vector<double>& sizes = sizes_.emplace_back();
    for (std::size_t c = 0; c < blends[k].contour_count(); ++c) {
      const double sum = area_at(blends[k], 0.0, c) + area_at(blends[k], 1.0, c);
      windings.push_back(sum < 0.0 ? -1.0 : 1.0);
      sizes.push_back(std::fabs(sum));
    }
  }
  std::vector<std::size_t> slower(pace_.size(), 0);
  for (bool again = true; again;) {
    again = false;
    for (std::size_t k = 0; k < blends.size(); ++k) {
      if (!is_worse(blends[k], k)) continue;
      for (std::size_t key : {k, k + 1}) {
        const bool end = key == 0 || key + 1 == pace_.size();
        // The ends of the whole move as their steps do, at any pace; those of a loop are one key.
        if (end && !loop_) continue;
        if (end) key = 0;
        if (slower[key] + 1 == kPaces.size()) continue;
        pace_[key] = kPaces[++slower[key]];
        if (end) pace_.back() = pace_.front();
        again = true;
      }
    }
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
