#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "match/sample_pair.h"
#include "match/search.h"
#include "tandem/match/match.h"
#include "tandem/match/rotation.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// @throws InvalidArgument the norm knows no turn: rulings join the curves where they lie
void check_turnable(const Norm& norm);

/// Two curves that are to be matched under the common turn.
struct RotationTask {
  SamplePair fine;
  SamplePair coarse;  ///< of the same curves, fewer
  Layout layout = Layout::open;
  std::shared_ptr<EdgePlans> plans = std::make_shared<EdgePlans>();  ///< of these samples
};

/// The common turn of the first curves to the second ones, and each pair's optimum under it.
struct FoundRotation {
  Rotation rotation;
  /// Per task; samples_b is turned back. Empty where only the coarse programmes were run: with
  /// coarse_to_fine, and when the curves stay as they lie for want of a gain.
  std::vector<SearchResult> found;
  bool cancelled = false;
};

/// Looks for the turn under which the pairs match best in sum, weighted with their lengths.
///
/// Candidates come from the cross-correlation of the tangents, forward and reversed; with them goes the
/// identity. From each, matching and Procrustes on the matched tangents alternate until the optimum stops
/// falling: first on the coarse samples, then, from the best, on the fine ones. For the turn that comes out
/// the optimum is exact, in the turn it is local. Among turns that are equally good (within 1e-9) the smaller
/// one is taken. least_gain: the curves stay as they lie unless the turn lowers the cost by this share.
/// Spec C11.
[[nodiscard]] FoundRotation find_rotation(std::span<const RotationTask> tasks, const MatchOptions& options,
                                          double least_gain);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
