#include "tandem/match/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "tandem/error.h"

namespace {

using tandem::assign;

double cost_of(const std::vector<double>& cost, std::size_t columns,
               const std::vector<std::optional<std::size_t>>& column_of) {
  double sum = 0.0;
  for (std::size_t i = 0; i < column_of.size(); ++i) {
    if (column_of[i]) sum += cost[i * columns + *column_of[i]];
  }
  return sum;
}

// Over all permutations of the larger side.
double brute_force(const std::vector<double>& cost, std::size_t rows, std::size_t columns) {
  std::vector<std::size_t> order(std::max(rows, columns));
  std::iota(order.begin(), order.end(), std::size_t{0});
  double best = std::numeric_limits<double>::infinity();
  do {
    double sum = 0.0;
    for (std::size_t k = 0; k < std::min(rows, columns); ++k) {
      sum += rows <= columns ? cost[k * columns + order[k]] : cost[order[k] * columns + k];
    }
    best = std::min(best, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(Assign, EqualsBruteForce) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::size_t> size(1, 6);
  for (int round = 0; round < 500; ++round) {
    const std::size_t rows = size(random);
    const std::size_t columns = size(random);
    // Small integers, so that there are ties; some negative.
    std::uniform_int_distribution<int> value(-3, 9);
    std::vector<double> cost(rows * columns);
    for (double& c : cost) c = value(random);
    const auto column_of = assign(cost, rows, columns);
    std::vector<std::size_t> used;
    for (const auto& column : column_of) {
      if (column) used.push_back(*column);
    }
    std::sort(used.begin(), used.end());
    EXPECT_EQ(used.size(), std::min(rows, columns));
    EXPECT_EQ(std::adjacent_find(used.begin(), used.end()), used.end());
    EXPECT_EQ(cost_of(cost, columns, column_of), brute_force(cost, rows, columns));
  }
}

TEST(Assign, TakesEmptySides) {
  EXPECT_TRUE(assign({}, 0, 3).empty());
  EXPECT_EQ(assign({}, 2, 0), (std::vector<std::optional<std::size_t>>(2)));
}

TEST(Assign, SaysWhatIsWrong) {
  const std::vector<double> cost = {1.0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_THROW((void)assign(cost, 1, 3), tandem::InvalidArgument);
  EXPECT_THROW((void)assign(cost, 1, 2), tandem::InvalidArgument);
}

}  // namespace
