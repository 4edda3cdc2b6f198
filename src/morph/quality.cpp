#include "tandem/morph/quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "morph/quality_frames.h"
#include "tandem/error.h"
#include "tandem/shape/intersections.h"

namespace tandem {
inline namespace v0 {
namespace {

// Crossings of one in-between that are looked at to tell whether contours cross themselves, each other, or
// both.
constexpr std::size_t kMostCrossings = 1000;

void check(const QualityOptions& options) {
  const auto refuse_negative = [](const char* name, double value) {
    if (!(value >= 0.0))
      throw InvalidArgument(fmt::format("morph quality: {} is {}, expected >= 0", name, value));
  };
  refuse_negative("largest_fold", options.largest_fold);
  refuse_negative("smooth_angle", options.smooth_angle);
}

// The larger diagonal of the boxes of two or more keys, so that the same epsilon holds for every in-between.
double largest_diagonal(const QualityFrames& frames) {
  double largest = 0.0;
  for (std::size_t i = 0; i < frames.size(); i += frames.per_key()) {
    Box box;
    const auto points = frames.points(i);
    for (std::size_t k = 0; k < points.size(); k += 2) box.include(points.subspan(k, 2));
    largest = std::max(largest, box.diagonal());
  }
  return largest;
}

struct Verdict {
  std::optional<Vec2> crossing;
  std::optional<Vec2> crossing_between;
  bool folded = false;

  [[nodiscard]] bool faulty() const { return crossing || crossing_between || folded; }
  [[nodiscard]] FaultPlace place(double s) const {
    if (crossing) return {MorphFault::crossing, s, crossing};
    if (crossing_between) return {MorphFault::crossing_between, s, crossing_between};
    return {MorphFault::fold, s, std::nullopt};
  }
};

class Judge {
 public:
  Judge(double scale, double largest_fold) : finder_({.scale = scale}), largest_fold_(largest_fold) {}

  Verdict operator()(std::span<const PathView> paths) {
    Verdict verdict;
    for (const Crossing& crossing : finder_.find(paths, kMostCrossings)) {
      auto& place = crossing.path_a == crossing.path_b ? verdict.crossing : verdict.crossing_between;
      if (!place) place = crossing.point;
    }
    closed_.clear();
    for (const PathView& path : paths) {
      if (path.closed) closed_.push_back(path);
    }
    verdict.folded = finder_.fold_fraction(closed_) > largest_fold_;
    return verdict;
  }

 private:
  CrossingFinder finder_;
  std::vector<PathView> closed_;
  double largest_fold_;
};

// 1 to count, those in the middle first: faults are most likely far from the keys.
std::vector<std::size_t> middle_first(std::size_t count) {
  std::vector<std::size_t> order;
  for (std::size_t i = 1; i <= count; ++i) order.push_back(i);
  const auto off_middle = [count](std::size_t i) {
    return 2 * i > count + 1 ? 2 * i - count - 1 : count + 1 - 2 * i;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return off_middle(a) < off_middle(b); });
  return order;
}

void judge_keys(const QualityFrames& frames, Judge& judge, MorphQuality& quality) {
  for (std::size_t i = 0; i < frames.size(); i += frames.per_key()) {
    if (judge(frames[i]).faulty()) ++quality.faulty_keys;
  }
}

void judge_in_betweens(const QualityFrames& frames, std::size_t most_faulty, Judge& judge,
                       MorphQuality& quality) {
  for (const std::size_t offset : middle_first(frames.per_key() - 1)) {
    for (std::size_t i = offset; i < frames.size(); i += frames.per_key()) {
      const Verdict verdict = judge(frames[i]);
      ++quality.in_betweens;
      if (!verdict.faulty()) continue;
      ++quality.faulty;
      if (verdict.crossing) ++quality.crossing;
      if (verdict.crossing_between) ++quality.crossing_between;
      if (verdict.folded) ++quality.folded;
      if (!quality.first || frames.s(i) < quality.first->s) quality.first = verdict.place(frames.s(i));
      if (quality.faulty > most_faulty) {
        quality.complete = false;
        return;
      }
    }
  }
}

}  // namespace

MorphQuality measure_quality(const PathSampler& sampler, const QualityOptions& options) {
  check(options);
  const QualityFrames frames(sampler, options);
  MorphQuality quality;
  Judge judge(largest_diagonal(frames), options.largest_fold);
  judge_in_betweens(frames, options.most_faulty, judge, quality);
  if (!quality.complete) return quality;
  judge_keys(frames, judge, quality);
  quality.g1_defect = measure_g1_defect(frames, options.smooth_angle);
  const SizeDeviation deviation = measure_sizes(frames);
  quality.length_deviation = deviation.length;
  quality.area_deviation = deviation.area;
  quality.step_ratio = measure_steps(frames);
  return quality;
}

MorphQuality measure_quality(const Motion& motion, const QualityOptions& options) {
  std::vector<CubicPath> paths;
  std::vector<PathView> views;
  return measure_quality(PathSampler([&](double s) -> std::span<const PathView> {
                           paths = motion(s);
                           views = view_paths(paths);
                           return views;
                         }),
                         options);
}

MorphQuality measure_quality(const PathMorph& morph, QualityOptions options) {
  options.key_count = morph.key_count();
  // The same number of in-betweens on every step, however long it takes.
  const auto s_at = [&](double even) {
    const KeyPosition at = locate_key(even, morph.key_count());
    const std::vector<double>& times = morph.key_times();
    if (at.local == 1.0) return times[at.key + 1];
    return times[at.key] + at.local * (times[at.key + 1] - times[at.key]);
  };
  MorphQuality quality = measure_quality(Motion([&](double even) { return morph.at(s_at(even)); }), options);
  if (quality.first) quality.first->s = s_at(quality.first->s);
  return quality;
}

}  // namespace v0
}  // namespace tandem
