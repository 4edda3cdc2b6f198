#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "match/lexicographic_nodes.h"
#include "match/skew_table.h"
#include "tandem/match/cost_table.h"

/// Vector kernels for [C] eq. (7): one source for every instruction set, the same bits on all of them (a sum
/// and a minimum per cell, in one order).
namespace tandem {
inline namespace v0 {
namespace detail {

/// What a step costs: the node it enters, that node's cost once more for a diagonal step that weighs two
/// (Sakoe and Chiba's symmetric form: all paths have the same total weight), and a charge for a step that is
/// not diagonal.
template <class V>
struct StepRule {
  bool double_diagonal = false;
  V charge = 0;

  [[nodiscard]] bool is_plain() const noexcept { return !double_diagonal && charge == V{0}; }
};

/// Columns of a path per row, from its first row on.
struct RowSpans {
  std::vector<int> first;
  std::vector<int> last;
};

/// Where paths may run: on or between two others, whose starts are rows (a,0) and (b,0), a <= b. A path from
/// the smaller row runs through larger columns. Null: no bound on that side.
struct Channel {
  int above_start = 0;
  const RowSpans* above = nullptr;
  int below_start = 0;
  const RowSpans* below = nullptr;

  [[nodiscard]] int first_column(int row) const {
    return below == nullptr || row < below_start ? 0
                                                 : below->first[static_cast<std::size_t>(row - below_start)];
  }
  [[nodiscard]] int last_column(int row, int width) const {
    const auto k = static_cast<std::size_t>(row - above_start);
    return above == nullptr || k >= above->last.size() ? width - 1 : above->last[k];
  }
};

/// A family of paths (k,0) -> (k + rows - 1, width - 1) through a table, one for each start k.
template <class V>
struct PathFamily {
  const SkewTable<V>* table = nullptr;
  int rows = 0;              ///< of each path
  bool count_start = false;  ///< whether the first node's cost counts
  StepRule<V> rule = {};
};

template <class V>
struct TracedCost {
  V cost = kUnreachable<V>;
  std::vector<Node> nodes;  ///< empty if the end is out of reach
};

/// The optimal path from start k within the channel. Ties: diagonal, left, up. Two bits are kept per node.
[[nodiscard]] TracedCost<double> trace_path(const PathFamily<double>& family, int k, const Channel& channel);
[[nodiscard]] TracedCost<std::int32_t> trace_path(const PathFamily<std::int32_t>& family, int k,
                                                  const Channel& channel);

/// The optimal path through an open table, (0,0) -> (rows - 1, cols - 1), likewise.
[[nodiscard]] TracedCost<double> trace_open(const LexicographicNodes& nodes);

/// How many starts start_costs takes at once.
[[nodiscard]] int start_lanes(double);
[[nodiscard]] int start_lanes(std::int32_t);

/// Costs of the optimal paths from the starts k .. k + costs.size() - 1, at most start_lanes of them, within
/// the channel; no paths.
void start_costs(const PathFamily<double>& family, int k, const Channel& channel, std::span<double> costs);
void start_costs(const PathFamily<std::int32_t>& family, int k, const Channel& channel,
                 std::span<std::int32_t> costs);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
