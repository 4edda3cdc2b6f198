#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "tandem/match/cost_table.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The nodes of a table as plain numbers whose sums are lexicographic: an invalid node costs a penalty above
/// anything that valid nodes can add up to, so that fewer invalid ones always win ([C]'s own way: Cost >=
/// 2m). The count of invalid nodes is exact, the costs to rounding at the size of the penalties; the penalty
/// is a power of two. Nodes that cost more than the threshold are barred. Column 0 may be any column of a
/// loop.
class LexicographicNodes {
 public:
  explicit LexicographicNodes(const NodeTable& table,
                              double threshold = std::numeric_limits<double>::infinity(),
                              std::size_t first_column = 0)
      : table_(table),
        first_column_(first_column),
        threshold_(std::min(threshold, std::numeric_limits<double>::max())) {
    double most = 0.0;
    for (const double c : table.cost) most = c > most && c <= threshold_ ? c : most;
    // A closed path has at most rows + cols nodes.
    const double total = most * static_cast<double>(table.rows + table.cols);
    penalty_ = std::scalbn(1.0, std::ilogb(std::max(total, 1e-300)) + 1);
  }

  [[nodiscard]] std::size_t rows() const noexcept { return table_.rows; }
  [[nodiscard]] std::size_t cols() const noexcept { return table_.cols; }
  [[nodiscard]] double operator()(std::size_t i, std::size_t j) const noexcept {
    const std::size_t column = j + first_column_;
    const std::size_t k = table_.index(i, column < table_.cols ? column : column - table_.cols);
    const double cost = table_.cost[k];
    const double counted = cost + (table_.invalid[k] != 0 ? penalty_ : 0.0);
    return cost <= threshold_ ? counted : std::numeric_limits<double>::infinity();
  }

 private:
  const NodeTable& table_;
  std::size_t first_column_;
  double threshold_;
  double penalty_ = 1.0;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
