#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "match/fixed_costs.h"
#include "tandem/match/cost_table.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// What the three-step programme of recognition charges: the node that a step leads to, once more for a
/// diagonal step with `double_diagonal`, and `charge` for a step that is not diagonal. The start of an open
/// path counts as a diagonal step does.
struct StepCharges {
  bool double_diagonal = false;
  double charge = 0.0;
};

/// An optimal path and what it costs.
struct PricedPath {
  double sum = 0.0;
  /// The start included; a closed path leads from (k, 0) to (k + m1, m2).
  std::vector<Node> nodes;
};

/// The path with the least sum of 1 - <T1,T2>; closed: over all starts. It is optimal for costs in fixed
/// point (match/fixed_costs.h), so that every machine finds the same one, and then priced in double.
/// Nothing when the sum is above `limit`; otherwise the result does not depend on it.
[[nodiscard]] std::optional<PricedPath> cheapest_path(const TangentPlanes& a, const TangentPlanes& b,
                                                      bool closed, const StepCharges& charges,
                                                      double limit = std::numeric_limits<double>::infinity());

}  // namespace detail
}  // namespace v0
}  // namespace tandem
