#include "morph/score.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "morph/measures.h"
#include "tandem/curve/bounding_box.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// In-betweens looked at: twentieths of the way, those that fail most often first.
constexpr std::array<int, 19> kOrder = {10, 6, 14, 3, 17, 8, 12, 4, 16, 2, 18, 7, 13, 5, 15, 9, 11, 1, 19};
constexpr int kParts = 20;
// Share of the filled region that may lie over itself unnoticed.
constexpr double kFold = 0.004;
// More crossings in one in-between make it no worse.
constexpr std::size_t kMostCrossings = 8;
// A region that lies over itself, in crossings.
constexpr double kFoldTrouble = 50.0;
// What area and length may become, relative to the linear blend of the ends' own, before it is a fault:
// tighter than what is seen as a collapse.
constexpr double kLeastArea = 0.55;
constexpr double kEven = 0.95;  // of the area of a body that grows evenly
constexpr double kLeastLength = 0.6;
constexpr double kMostLength = 1.4;

// How far from the middle of both keys in-betweens may reach unnoticed, in halves of the diagonal: what turns
// on the spot stays within 1, an outline that unrolls does not.
constexpr double kReach = 1.3;

// Diagonals of a key that a point may move by per unit of s where it leaves it: within 1/5000 of the way
// it is then still within 1e-3 of its place, as ends that are exact should be (docs/interface.md).
constexpr double kMostSpeed = 4.8;
constexpr double kInstant = 2e-4;

// A joint that turns by this much more than in both keys is seen to.
constexpr double kSeenBreak = 0.02;

// Weights of the blemishes, found by looking at sheets of icons.
constexpr double kBreakWeight = 1.0;
constexpr double kAreaWeight = 1.0;
constexpr double kLengthWeight = 1.0;
constexpr double kTangentWeight = 0.6;
constexpr double kTurnWeight = 2.0;  // of half a turn
constexpr double kReachWeight = 0.5;
// A correspondence that is off by 2 % of the length is seen as lopsided at once, and costs as
// much as a turn of 11 degrees.
constexpr double kAsymmetryWeight = 6.0;
// 1 - <T1, T2> of a contour that grows from a point, or shrinks to one: as of one that turns by 90 degrees.
constexpr double kLoneTangent = 1.0;
// Shapes whose tangents differ by less once they are turned are nearly one body, whose turn costs less.
constexpr double kUnlike = 0.1;

double at(int part) {
  return static_cast<double>(part) / kParts;
}

struct Sums {
  double area = 0.0;
  double length = 0.0;
};

struct EndLengths {
  double first = 0.0;
  double last = 0.0;
};

// Of what is drawn at both ends beyond what is blended.
EndLengths lengths_beyond(const StepBlend& blend, std::size_t contour, const ContourEnds& ends) {
  if (!blend.has_outlines(contour)) return {};
  std::vector<double> points(blend.size(contour));
  blend.at(0.0, contour, points);
  const double first = path_length(points) - path_length(ends.a.control_points().data());
  blend.at(1.0, contour, points);
  return {first, path_length(points) - path_length(ends.b.control_points().data())};
}

// The turn on the spot at a joint, as the chord of its angle.
double break_size(std::span<const double> points, std::size_t joint) {
  return std::sqrt(2.0 * std::max(0.0, direction_break(points, joint)));
}

// Per joint, that of the key that turns more.
std::vector<double> worse_breaks(const ContourEnds& ends) {
  const std::span<const double> a = ends.a.control_points().data();
  const std::span<const double> b = ends.b.control_points().data();
  std::vector<double> worse;
  for (std::size_t joint = ends.a.is_closed() ? 0 : 3; joint + 3 < a.size() / 2; joint += 3) {
    worse.push_back(std::max(break_size(a, joint), break_size(b, joint)));
  }
  return worse;
}

double polygon_length(std::span<const double> p) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 3 < p.size(); i += 2) {
    const double x = p[i + 2] - p[i];
    const double y = p[i + 3] - p[i + 1];
    sum += std::sqrt(x * x + y * y);
  }
  return sum;
}

// Of a contour that is a point in the other key; 0 of others.
double lone_length(std::span<const double> a, std::span<const double> b) {
  const double of_a = polygon_length(a);
  const double of_b = polygon_length(b);
  return of_a > 0.0 && of_b > 0.0 ? 0.0 : of_a + of_b;
}

// The mean of 1 - <T1, T2> over aligned edges of the control polygons, weighted with their lengths, as
// the frame sees them. What grows from a point has nothing to be compared with.
double tangent_difference(std::span<const ContourEnds> ends) {
  double sum = 0.0;
  double whole = 0.0;
  for (const ContourEnds& contour : ends) {
    const std::span<const double> a = contour.a.control_points().data();
    const std::span<const double> b = contour.b.control_points().data();
    const double lone = lone_length(a, b);
    sum += kLoneTangent * lone;
    whole += lone;
    for (std::size_t i = 0; i + 3 < a.size(); i += 2) {
      const double ax = a[i + 2] - a[i], ay = a[i + 3] - a[i + 1];
      const double bx = b[i + 2] - b[i], by = b[i + 3] - b[i + 1];
      const double la = std::sqrt(ax * ax + ay * ay);
      const double lb = std::sqrt(bx * bx + by * by);
      if (!(la > 0.0 && lb > 0.0)) continue;
      const double weight = la + lb;
      sum += weight * (1.0 - (ax * bx + ay * by) / (la * lb));
      whole += weight;
    }
  }
  return whole > 0.0 ? sum / whole : 0.0;
}

}  // namespace

Judge::Judge(double diagonal) {
  for (int part = 0; part <= kParts; ++part) finders_.emplace_back(IntersectionOptions{.scale = diagonal});
}

void Judge::sample(const StepBlend& blend, double s) {
  points_.resize(blend.contour_count());
  views_.resize(blend.contour_count());
  for (std::size_t c = 0; c < points_.size(); ++c) {
    points_[c].resize(blend.size(c));
    blend.at(s, c, points_[c]);
    views_[c] = {points_[c], blend.is_closed(c)};
  }
}

// 0 where nothing crosses or folds.
double Judge::trouble_of_frame(int part) {
  CrossingFinder& finder = finders_[static_cast<std::size_t>(part)];
  double trouble = static_cast<double>(finder.find(views_, kMostCrossings).size());
  std::vector<PathView> closed;
  for (const PathView& view : views_) {
    if (view.closed) closed.push_back(view);
  }
  if (closed.size() > 1) {
    const double fold = finder.fold_fraction(closed);
    if (fold > kFold) trouble += kFoldTrouble * fold;
  }
  return trouble;
}

struct Judge::Reference {
  explicit Reference(const StepBlend& blend) : ends(blend.ends_in_frame()) {
    for (const ContourEnds& contour : ends) {
      breaks.push_back(worse_breaks(contour));
      joints += static_cast<double>(breaks.back().size());
      first.length += path_length(contour.a.control_points().data());
      last.length += path_length(contour.b.control_points().data());
      const EndLengths more = lengths_beyond(blend, breaks.size() - 1, contour);
      beyond.first += more.first;
      beyond.last += more.last;
      if (!contour.a.is_closed()) continue;
      first.area += signed_area(contour.a.control_points().data());
      last.area += signed_area(contour.b.control_points().data());
    }
    first.area = std::fabs(first.area);
    last.area = std::fabs(last.area);
  }

  std::vector<ContourEnds> ends;
  std::vector<std::vector<double>> breaks;  ///< of the keys, by joint
  double joints = 0.0;
  Sums first;
  Sums last;
  EndLengths beyond;
};

// Of the in-between that was sampled last.
void Judge::add_trouble(int part, Score& score) {
  const double s = at(part);
  // What crosses in both keys already is no fault of the in-betweens.
  const double own = (1.0 - s) * (*trouble_of_keys_)[0] + s * (*trouble_of_keys_)[1];
  const double trouble = std::max(0.0, trouble_of_frame(part) - own);
  if (trouble > 0.0) ++score.faults;
  score.trouble += trouble;
}

// Of the same, what needs no look for crossings.
void Judge::add_measures(const StepBlend& blend, const Reference& keys, double s, Score& score) const {
  Sums now;
  double broken = 0.0;
  double reach = 0.0;
  for (std::size_t c = 0; c < points_.size(); ++c) {
    now.length += path_length(points_[c]);
    for (std::size_t i = 0; i + 1 < points_[c].size(); i += 6) {  // joints
      const double x = (points_[c][i] - center_.x) / radius_;
      const double y = (points_[c][i + 1] - center_.y) / radius_;
      reach = std::max(reach, x * x + y * y);
    }
    if (keys.ends[c].a.is_closed()) now.area += signed_area(points_[c]);
    const std::size_t first_joint = keys.ends[c].a.is_closed() ? 0 : 3;
    for (std::size_t k = 0; k < keys.breaks[c].size(); ++k) {
      const double more = break_size(points_[c], first_joint + 3 * k) - keys.breaks[c][k];
      if (more > kSeenBreak) broken += more;
    }
  }
  const double progress = blend.progress(s);
  const StepBlend::OutlineShares left = StepBlend::outline_shares(s);
  const double length = now.length / ((1.0 - progress) * keys.first.length + progress * keys.last.length +
                                      left.first * keys.beyond.first + left.last * keys.beyond.last);
  if (length < kLeastLength || length > kMostLength) ++score.faults;
  score.blemish += kReachWeight * std::max(0.0, std::sqrt(reach) - kReach) / kOrder.size();
  const double wanted = (1.0 - progress) * keys.first.area + progress * keys.last.area;
  if (wanted > 0.0) {
    const double area = std::fabs(now.area) / wanted;
    // A body that grows evenly is smaller on the way than the blend of its areas, rightly.
    const double side = (1.0 - progress) * std::sqrt(keys.first.area) + progress * std::sqrt(keys.last.area);
    if (area < std::min(kLeastArea, kEven * side * side / wanted)) ++score.faults;
    score.blemish += kAreaWeight * std::fabs(area - 1.0) / kOrder.size();
  }
  score.blemish += kLengthWeight * std::fabs(length - 1.0) / kOrder.size();
  if (keys.joints > 0.0) score.blemish += kBreakWeight * broken / std::sqrt(keys.joints) / kOrder.size();
}

void Judge::look_at_keys(const StepBlend& blend) {
  if (trouble_of_keys_) return;
  Box box;
  const auto include_all = [&] {
    for (const std::vector<double>& points : points_) {
      for (std::size_t i = 0; i + 1 < points.size(); i += 6) box.include(std::span(points).subspan(i, 2));
    }
  };
  sample(blend, 0.0);
  include_all();
  const double of_first = trouble_of_frame(0);
  sample(blend, 1.0);
  include_all();
  trouble_of_keys_ = {of_first, trouble_of_frame(kParts)};
  center_ = {0.5 * (box.lo[0] + box.hi[0]), 0.5 * (box.lo[1] + box.hi[1])};
  radius_ = 0.5 * box.diagonal();
}

// is_beaten(score): whether to look no further. measure_first: where only what is free of faults can win,
// crossings, which take longest, are looked for last.
template <class IsBeaten>
Score Judge::look(const StepBlend& blend, double asymmetry, bool measure_first, const IsBeaten& is_beaten) {
  const Reference keys(blend);
  Score score{0, 0.0, kAsymmetryWeight * asymmetry};
  const double difference = tangent_difference(keys.ends);
  score.blemish += kTangentWeight * difference;
  // What is nothing but a turned copy turns for free.
  score.blemish += kTurnWeight * std::fabs(blend.degrees()) / 180.0 * std::min(1.0, difference / kUnlike);
  look_at_keys(blend);
  if (measure_first) {
    for (const int part : kOrder) {
      sample(blend, at(part));
      add_measures(blend, keys, at(part), score);
      if (is_beaten(score)) return score;
    }
  }
  for (const int part : kOrder) {
    sample(blend, at(part));
    add_trouble(part, score);
    if (!measure_first) add_measures(blend, keys, at(part), score);
    if (is_beaten(score)) {
      last_looked_ = part;
      return score;
    }
  }
  if (leaves_too_fast(blend)) score.faults += static_cast<int>(kOrder.size());
  return score;
}

Score Judge::judge(const StepBlend& blend, const Score& limit, double asymmetry) {
  return look(blend, asymmetry, limit.faults == 0, [&](const Score& score) {
    return score.faults > limit.faults || (score.faults == 0 && !score.better_than(limit));
  });
}

std::optional<Score> Judge::beat(const StepBlend& blend, const Score& limit, double asymmetry) {
  const Score score = look(blend, asymmetry, limit.faults == 0, [&](const Score& now) {
    // Neither falls; blemishes count when all else is equal.
    if (now.faults != limit.faults) return now.faults > limit.faults;
    return now.faults > 0 ? now.trouble > limit.trouble : !now.better_than(limit);
  });
  return score.better_than(limit) ? std::optional(score) : std::nullopt;
}

std::optional<Score> Judge::find_faultless(const StepBlend& blend, double asymmetry) {
  look_at_keys(blend);
  if (last_fault_ > 0) {
    Score score{0, 0.0, 0.0};
    sample(blend, at(last_fault_));
    add_trouble(last_fault_, score);
    if (score.faults > 0) return std::nullopt;
  }
  const Score score = look(blend, asymmetry, false, [](const Score& now) { return now.faults > 0; });
  if (score.faults == 0) return score;
  last_fault_ = last_looked_;
  return std::nullopt;
}

// Whether a point is so fast at an end that the end seems to jump, in diagonals of that key.
bool Judge::leaves_too_fast(const StepBlend& blend) {
  for (const double end : {0.0, 1.0}) {
    sample(blend, end);
    const std::vector<std::vector<double>> at_end = points_;
    Box box;
    for (const std::vector<double>& points : at_end) {
      for (std::size_t i = 0; i + 1 < points.size(); i += 2) box.include(std::span(points).subspan(i, 2));
    }
    const double most = kMostSpeed * kInstant * box.diagonal();
    sample(blend, std::fabs(end - kInstant));
    for (std::size_t c = 0; c < at_end.size(); ++c) {
      for (std::size_t i = 0; i + 1 < at_end[c].size(); i += 2) {
        const double x = (points_[c][i] - at_end[c][i]) / most;  // squares stay in range
        const double y = (points_[c][i + 1] - at_end[c][i + 1]) / most;
        if (!(x * x + y * y <= 1.0)) return true;  // nor if it is not finite
      }
    }
  }
  return false;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
