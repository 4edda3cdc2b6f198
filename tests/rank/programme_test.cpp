#include "rank/programme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "rank/shapes.h"

namespace {

using tandem::Node;
using tandem::detail::CostTable;
using tandem::detail::Optimum;
using tandem::detail::StepRule;
using tandem::testing_rank::uniform;

/// All paths, one by one.
double least_by_enumeration(const CostTable& table, bool closed, const StepRule& rule) {
  const std::size_t rows = closed ? table.rows : table.rows - 1;
  const std::size_t cols = closed ? table.cols : table.cols - 1;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < (closed ? table.rows : 1); ++k) {
    const std::function<void(std::size_t, std::size_t, double)> walk = [&](std::size_t i, std::size_t j,
                                                                           double sum) {
      if (i == rows && j == cols) {
        best = std::min(best, sum);
        return;
      }
      const auto node = [&](std::size_t r, std::size_t c) {
        return table.at((k + r) % table.rows, c % table.cols);
      };
      if (i < rows && j < cols) walk(i + 1, j + 1, sum + rule.diagonal_weight * node(i + 1, j + 1));
      if (j < cols) walk(i, j + 1, sum + (node(i, j + 1) + rule.charge));
      if (i < rows) walk(i + 1, j, sum + (node(i + 1, j) + rule.charge));
    };
    walk(0, 0, closed ? 0.0 : rule.diagonal_weight * table.at(0, 0));
  }
  return best;
}

double sum_along(const CostTable& table, bool closed, const StepRule& rule, const std::vector<Node>& path) {
  double sum = closed ? 0.0 : rule.diagonal_weight * table.at(0, 0);
  for (std::size_t k = 1; k < path.size(); ++k) {
    const int di = path[k].i - path[k - 1].i;
    const int dj = path[k].j - path[k - 1].j;
    EXPECT_TRUE((di == 0 || di == 1) && (dj == 0 || dj == 1) && di + dj > 0);
    const double cost = table.at(static_cast<std::size_t>(path[k].i) % table.rows,
                                 static_cast<std::size_t>(path[k].j) % table.cols);
    sum += di + dj == 2 ? rule.diagonal_weight * cost : cost + rule.charge;
  }
  return sum;
}

TEST(RankProgramme, EqualsEnumeration) {
  std::mt19937 random(31);
  for (int round = 0; round < 400; ++round) {
    CostTable table{1 + random() % 5, 1 + random() % 5, {}};
    for (std::size_t k = 0; k < table.rows * table.cols; ++k)
      table.cost.push_back(round % 2 == 0 ? uniform(random, 0.0, 2.0) : static_cast<double>(random() % 3));
    const StepRule rule{round % 3 == 0 ? 1.0 : 2.0, round % 4 == 0 ? 0.0 : 0.125};
    for (const bool closed : {false, true}) {
      const double least = least_by_enumeration(table, closed, rule);
      const Optimum found = optimum(table, closed, rule);
      EXPECT_NEAR(found.sum, least, 1e-12);
      ASSERT_GE(found.start, 0);
      const std::vector<Node> path = trace(table, closed, rule, found.start);
      EXPECT_EQ(path.front(), (Node{found.start, 0}));
      const int end = closed ? 0 : 1;
      EXPECT_EQ(path.back(),
                (Node{found.start + static_cast<int>(table.rows) - end, static_cast<int>(table.cols) - end}));
      EXPECT_NEAR(sum_along(table, closed, rule, path), least, 1e-12);
      EXPECT_EQ(optimum(table, closed, rule, found.sum).start, found.start);
      EXPECT_EQ(optimum(table, closed, rule, found.sum - 1e-9).start, -1);
    }
  }
}

}  // namespace
