#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

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
    const double most = largest_cost();
    // A closed path has at most rows + cols nodes.
    const double total = most * static_cast<double>(table.rows + table.cols);
    penalty_ = std::scalbn(1.0, std::ilogb(std::max(total, 1e-300)) + 1);
  }

  [[nodiscard]] std::size_t rows() const noexcept { return table_.rows; }
  [[nodiscard]] std::size_t cols() const noexcept { return table_.cols; }

  /// Columns first .. first + n - 1 of row i, to every stride-th place from `out` on.
  void copy(std::size_t i, std::size_t first, std::size_t n, double* out, std::size_t stride) const noexcept {
    // Of a loop's lap, what comes before its end, then the rest.
    std::size_t column = first + first_column_;
    if (column >= table_.cols) column -= table_.cols;
    const std::size_t before_end = std::min(n, table_.cols - column);
    copy_run(table_.index(i, column), before_end, out, stride);
    if (before_end < n) copy_run(table_.index(i, 0), n - before_end, out + before_end * stride, stride);
  }

 private:
  void copy_run(std::size_t at, std::size_t n, double* out, std::size_t stride) const noexcept {
    const double* cost = table_.cost.data() + at;
    const std::uint8_t* invalid = table_.invalid.data() + at;
    // Copies, which writing to `out` cannot change.
    const double penalty = penalty_;
    const double threshold = threshold_;
    for (std::size_t k = 0; k < n; ++k) {
      const double counted = cost[k] + penalty * invalid[k];
      out[k * stride] = cost[k] <= threshold ? counted : std::numeric_limits<double>::infinity();
    }
  }

  /// Of the nodes that are not barred. Four at a time: each maximum waits for the one before it.
  [[nodiscard]] double largest_cost() const noexcept {
    double most[4] = {0.0, 0.0, 0.0, 0.0};
    const std::vector<double>& cost = table_.cost;
    const double threshold = threshold_;
    const std::size_t whole = cost.size() / 4 * 4;
    const auto larger = [threshold](double x, double c) { return c > x && c <= threshold ? c : x; };
    for (std::size_t k = 0; k < whole; k += 4) {
      for (std::size_t lane = 0; lane < 4; ++lane) most[lane] = larger(most[lane], cost[k + lane]);
    }
    for (std::size_t k = whole; k < cost.size(); ++k) most[0] = larger(most[0], cost[k]);
    return std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
  }

  const NodeTable& table_;
  std::size_t first_column_;
  double threshold_;
  double penalty_ = 1.0;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
