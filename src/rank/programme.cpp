#include "rank/programme.h"

#include <algorithm>
#include <cstdint>

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// All starts at once: the innermost loop runs over the starts, which are independent of one another.
Optimum closed_optimum(const CostTable& table, const StepRule& rule, double limit) {
  const std::size_t m1 = table.rows;
  const std::size_t m2 = table.cols;
  // by_column[j][i], the rows twice, so that start k finds row k + i beside those of the other starts.
  std::vector<double> by_column(m2 * (2 * m1 + 1));
  const auto column = [&](std::size_t j) { return by_column.data() + (j % m2) * (2 * m1 + 1); };
  for (std::size_t j = 0; j < m2; ++j) {
    for (std::size_t i = 0; i <= 2 * m1; ++i) column(j)[i] = table.at(i % m1, j);
  }
  std::vector<double> row((m2 + 1) * m1, 0.0);
  const auto at = [&](std::size_t j) { return row.data() + j * m1; };
  for (std::size_t j = 1; j <= m2; ++j) {
    for (std::size_t k = 0; k < m1; ++k) at(j)[k] = at(j - 1)[k] + (column(j)[k] + rule.charge);
  }
  std::vector<double> diagonal(m1);
  std::vector<double> next(m1);
  for (std::size_t i = 1; i <= m1; ++i) {
    std::copy(at(0), at(0) + m1, diagonal.begin());
    for (std::size_t k = 0; k < m1; ++k) at(0)[k] += column(0)[k + i] + rule.charge;
    for (std::size_t j = 1; j <= m2; ++j) {
      const double* cost = column(j) + i;
      const double* left = at(j - 1);
      double* here = at(j);
      for (std::size_t k = 0; k < m1; ++k) {
        next[k] = here[k];
        const double side = std::min(left[k], here[k]) + (cost[k] + rule.charge);
        here[k] = std::min(diagonal[k] + rule.diagonal_weight * cost[k], side);
      }
      std::swap(diagonal, next);
    }
  }
  const auto best = std::min_element(at(m2), at(m2) + m1);
  if (!(*best <= limit)) return {};
  return {static_cast<int>(best - at(m2)), *best};
}

/// The table of accumulated costs from one start.
class Table {
 public:
  Table(const CostTable& costs, bool closed, const StepRule& rule, int start)
      : costs_(costs),
        rule_(rule),
        start_(static_cast<std::size_t>(start)),
        rows_(closed ? costs.rows + 1 : costs.rows),
        cols_(closed ? costs.cols + 1 : costs.cols),
        sum_(rows_ * cols_, kInfinity),
        move_(rows_ * cols_, 0) {
    sum_[0] = closed ? 0.0 : rule.diagonal_weight * node(0, 0);
    for (std::size_t i = 0; i < rows_; ++i) {
      for (std::size_t j = 0; j < cols_; ++j) {
        if (i + j > 0) relax(i, j);
      }
    }
  }

  [[nodiscard]] double end() const { return sum_.back(); }

  [[nodiscard]] std::vector<Node> path() const {
    std::vector<Node> nodes;
    std::size_t i = rows_ - 1;
    std::size_t j = cols_ - 1;
    for (;;) {
      nodes.push_back({static_cast<int>(start_ + i), static_cast<int>(j)});
      if (i + j == 0) break;
      const std::uint8_t move = move_[i * cols_ + j];
      if (move != kLeft) --i;
      if (move != kUp) --j;
    }
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }

 private:
  enum Move : std::uint8_t { kDiagonal, kLeft, kUp };

  [[nodiscard]] double node(std::size_t i, std::size_t j) const {
    return costs_.at((start_ + i) % costs_.rows, j % costs_.cols);
  }

  void relax(std::size_t i, std::size_t j) {
    const double cost = node(i, j);
    const std::size_t k = i * cols_ + j;
    const auto offer = [&](double sum, Move move) {
      if (!(sum < sum_[k])) return;
      sum_[k] = sum;
      move_[k] = move;
    };
    if (i > 0 && j > 0) offer(sum_[k - cols_ - 1] + rule_.diagonal_weight * cost, kDiagonal);
    if (j > 0) offer(sum_[k - 1] + (cost + rule_.charge), kLeft);
    if (i > 0) offer(sum_[k - cols_] + (cost + rule_.charge), kUp);
  }

  const CostTable& costs_;
  StepRule rule_;
  std::size_t start_;
  std::size_t rows_;
  std::size_t cols_;
  std::vector<double> sum_;
  std::vector<std::uint8_t> move_;
};

}  // namespace

Optimum optimum(const CostTable& table, bool closed, const StepRule& rule, double limit) {
  if (closed) return closed_optimum(table, rule, limit);
  const double sum = Table(table, false, rule, 0).end();
  if (!(sum <= limit)) return {};
  return {0, sum};
}

std::vector<Node> trace(const CostTable& table, bool closed, const StepRule& rule, int start) {
  return Table(table, closed, rule, start).path();
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
