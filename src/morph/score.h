#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "morph/step_blend.h"
#include "tandem/shape/intersections.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// How good the in-betweens of a step are; less is better.
struct Score {
  /// In-betweens that cross or fold, in which a closed contour loses too much area, or length leaves its
  /// bounds; as if all were, where a key is left too fast.
  int faults = std::numeric_limits<int>::max();
  /// How much of that there is: crossings and shares of folded regions, summed up.
  double trouble = std::numeric_limits<double>::infinity();
  /// What is left to like better: breaks at smooth joints, area and length off their linear blends, tangents
  /// that turn, the turn of the whole, and what reaches beyond both keys.
  double blemish = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool better_than(const Score& other) const {
    if (faults != other.faults) return faults < other.faults;
    if (faults > 0 && trouble != other.trouble) return trouble < other.trouble;
    return blemish < other.blemish;
  }
};

/// Judges candidates for the in-betweens of one step.
class Judge {
 public:
  /// diagonal: of the box of both keys.
  explicit Judge(double diagonal);

  /// The score, as far as needed to know whether it beats `limit`: what is beaten can still be told from
  /// what is worse. asymmetry: StepCandidate::asymmetry
  [[nodiscard]] Score judge(const StepBlend& blend, const Score& limit, double asymmetry = 0.0);
  /// The score if it beats `limit`: sooner decided.
  [[nodiscard]] std::optional<Score> beat(const StepBlend& blend, const Score& limit, double asymmetry = 0.0);
  /// The score if it is free of faults. Where a fault was found the last time is looked at first.
  [[nodiscard]] std::optional<Score> find_faultless(const StepBlend& blend, double asymmetry = 0.0);

 private:
  /// What the in-betweens are measured by.
  struct Reference;

  template <class IsBeaten>
  [[nodiscard]] Score look(const StepBlend& blend, double asymmetry, bool measure_first,
                           const IsBeaten& is_beaten);
  void look_at_keys(const StepBlend& blend);
  [[nodiscard]] double trouble_of_frame(int part);
  void add_trouble(int part, Score& score);
  void add_measures(const StepBlend& blend, const Reference& keys, double s, Score& score) const;
  void sample(const StepBlend& blend, double s);
  [[nodiscard]] bool leaves_too_fast(const StepBlend& blend);

  // One for each in-between, and for both keys: most contours are as they were the last time.
  std::vector<CrossingFinder> finders_;
  std::optional<std::array<double, 2>> trouble_of_keys_;
  Vec2 center_{};        ///< of the box of both keys
  double radius_ = 0.0;  ///< half its diagonal
  int last_looked_ = 0;  ///< the twentieth of the way where look() ended
  int last_fault_ = 0;   ///< the twentieth of the way where find_faultless() found one
  std::vector<std::vector<double>> points_;
  std::vector<PathView> views_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
