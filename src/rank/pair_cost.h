#pragma once

#include <optional>
#include <vector>

#include "match/fixed_costs.h"
#include "tandem/match/cost_table.h"
#include "tandem/rank/compare.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// One side of a comparison as the programmes see it.
struct Chords {
  const TangentPlanes& tangents;
  const std::vector<double>& lengths;
};

/// The optimal path between two rows of chords at a fixed turn, and its cost per unit of path.
struct Fit {
  double cost = 0.0;
  std::vector<Node> path;  ///< empty: the elastic steps cannot bridge the numbers of nodes, cost is infinite
};

/// Nothing when the cost is above `limit`. The result does not depend on the limit otherwise.
[[nodiscard]] std::optional<Fit> fit_pair(const Chords& a, const Chords& b, bool closed,
                                          const CompareOptions& options, double limit);

/// The sum of y x^T over the pairs x, y of tangents that the fit brings together, weighted as the cost
/// weights them: row-major dim x dim, as nearest_rotation() takes it.
[[nodiscard]] std::vector<double> covariance(const Chords& a, const Chords& b, const CompareOptions& options,
                                             const Fit& fit);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
