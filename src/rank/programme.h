#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "tandem/match/cost_table.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// What a three-step programme charges: node cost times `diagonal_weight` for a diagonal step, node cost plus
/// `charge` for any other. The node is the one that the step leads to; the start of an open path counts as a
/// diagonal step does.
struct StepRule {
  double diagonal_weight = 1.0;
  double charge = 0.0;
};

/// A rows x cols table of node costs, row by row.
struct CostTable {
  std::size_t rows = 0;
  std::size_t cols = 0;
  std::vector<double> cost;

  [[nodiscard]] double at(std::size_t i, std::size_t j) const noexcept { return cost[i * cols + j]; }
};

/// The least sum over all paths (open), or over all starts k of closed paths (k,0) -> (k + rows, cols).
struct Optimum {
  int start = -1;  ///< closed: the smallest k that attains it; open: 0; -1: there is none within the limit
  double sum = std::numeric_limits<double>::infinity();
};

/// Gives up, with start -1, once it is certain that the sum is above `limit`.
[[nodiscard]] Optimum optimum(const CostTable& table, bool closed, const StepRule& rule,
                              double limit = std::numeric_limits<double>::infinity());

/// The nodes of an optimal path from that start, the start included; a closed path ends at
/// (start + rows, cols). Ties: diagonal first, then (i, j-1), then (i-1, j).
[[nodiscard]] std::vector<Node> trace(const CostTable& table, bool closed, const StepRule& rule, int start);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
