#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "match/fixed_costs.h"
#include "rank/programme.h"

namespace tandem::testing_rank {

/// The three-step programme in doubles, row by row, from every start: what the fast one is held against.
class PlainProgramme {
 public:
  PlainProgramme(const detail::TangentPlanes& a, const detail::TangentPlanes& b, bool closed,
                 const detail::StepCharges& charges)
      : a_(a), b_(b), closed_(closed), charges_(charges), diagonal_(charges.double_diagonal ? 2.0 : 1.0) {}

  [[nodiscard]] double best_sum() const {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < (closed_ ? a_.size() : 1); ++k) best = std::min(best, sum_from(k));
    return best;
  }

  [[nodiscard]] double node(std::size_t i, std::size_t j) const {
    double product = 0.0;
    for (std::size_t c = 0; c < a_.planes.size(); ++c)
      product += a_.planes[c][i % a_.size()] * b_.planes[c][j % b_.size()];
    return std::max(0.0, 1.0 - product);
  }

  [[nodiscard]] double sum_along(const std::vector<Node>& path) const {
    const auto at = [&](const Node& n) {
      return node(static_cast<std::size_t>(n.i), static_cast<std::size_t>(n.j));
    };
    double sum = closed_ ? 0.0 : diagonal_ * at(path.front());
    for (std::size_t k = 1; k < path.size(); ++k) {
      const bool diagonal = path[k].i != path[k - 1].i && path[k].j != path[k - 1].j;
      sum += diagonal ? diagonal_ * at(path[k]) : at(path[k]) + charges_.charge;
    }
    return sum;
  }

 private:
  [[nodiscard]] double sum_from(std::size_t start) const {
    const std::size_t rows = a_.size() + (closed_ ? 1 : 0);
    const std::size_t cols = b_.size() + (closed_ ? 1 : 0);
    std::vector<double> sum(rows * cols, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < cols; ++j) {
        double& here = sum[i * cols + j];
        const double cost = node(start + i, j);
        if (i + j == 0) here = closed_ ? 0.0 : diagonal_ * cost;
        if (i > 0 && j > 0) here = std::min(here, sum[(i - 1) * cols + j - 1] + diagonal_ * cost);
        if (j > 0) here = std::min(here, sum[i * cols + j - 1] + (cost + charges_.charge));
        if (i > 0) here = std::min(here, sum[(i - 1) * cols + j] + (cost + charges_.charge));
      }
    }
    return sum.back();
  }

  const detail::TangentPlanes& a_;
  const detail::TangentPlanes& b_;
  bool closed_;
  detail::StepCharges charges_;
  double diagonal_;
};

}  // namespace tandem::testing_rank
