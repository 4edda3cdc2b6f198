#include "match/three_step_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "match/fixed_costs.h"
#include "match/instruction_sets.h"
#include "match/start_family.h"
#include "tandem/match/match.h"

namespace tandem {
namespace {

using detail::FixedCosts;
using detail::kUnreachable;
using detail::PathFamily;
using detail::SkewTable;
using detail::StartFamily;
using detail::StepRule;
using detail::TracedCost;

/// Node costs of both kinds of numbers: few levels (ties), many, or plateaus of equal rows and columns.
template <class V>
SkewTable<V> random_table(std::mt19937& random, std::size_t rows, std::size_t cols, bool closed) {
  SkewTable<V> table(rows, cols + (closed ? 1 : 0));
  const unsigned levels = random() % 3 == 0 ? 1000 : 1 + random() % 6;
  const std::size_t plateau = 1 + random() % 5;
  std::vector<V> values(rows * cols);
  // Eighths: sums of them are exact.
  const V unit = std::is_integral_v<V> ? V{1} : static_cast<V>(0.125);
  for (V& v : values) v = static_cast<V>(random() % levels) * unit;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < cols; ++j)
      table.at(i, j) = values[i / plateau * plateau * cols + j / plateau * plateau];
    if (closed) table.at(i, cols) = table.at(i, 0);
  }
  return table;
}

/// The recurrence as it is written, from one start.
template <class V>
V plain_cost(const PathFamily<V>& family, int k) {
  const SkewTable<V>& table = *family.table;
  const auto width = static_cast<std::size_t>(table.width());
  const auto rows = static_cast<std::size_t>(family.rows);
  std::vector<V> cost(rows * width);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < width; ++j) {
      const V node = table.at((static_cast<std::size_t>(k) + i) % static_cast<std::size_t>(table.rows()), j);
      if (i == 0 && j == 0) {
        cost[0] = family.count_start ? node : V{0};
        continue;
      }
      V best = kUnreachable<V>;
      const V weighted = family.rule.double_diagonal ? static_cast<V>(node + node) : node;
      if (i > 0 && j > 0) best = std::min<V>(best, cost[(i - 1) * width + j - 1] + weighted);
      if (j > 0) best = std::min<V>(best, cost[i * width + j - 1] + family.rule.charge + node);
      if (i > 0) best = std::min<V>(best, cost[(i - 1) * width + j] + family.rule.charge + node);
      cost[i * width + j] = best;
    }
  }
  return cost.back();
}

/// What a path costs, step by step; a step that is none fails.
template <class V>
V cost_along(const PathFamily<V>& family, const std::vector<Node>& nodes) {
  const SkewTable<V>& table = *family.table;
  const auto at = [&](const Node& n) {
    return table.at(static_cast<std::size_t>(n.i) % static_cast<std::size_t>(table.rows()),
                    static_cast<std::size_t>(n.j));
  };
  V cost = family.count_start ? at(nodes.front()) : V{0};
  for (std::size_t n = 1; n < nodes.size(); ++n) {
    const int di = nodes[n].i - nodes[n - 1].i;
    const int dj = nodes[n].j - nodes[n - 1].j;
    EXPECT_TRUE(di >= 0 && di <= 1 && dj >= 0 && dj <= 1 && di + dj > 0);
    cost += at(nodes[n]);
    if (di == 1 && dj == 1) {
      if (family.rule.double_diagonal) cost += at(nodes[n]);
    } else {
      cost += family.rule.charge;
    }
  }
  return cost;
}

template <class V>
void check_random_families(unsigned seed, int instances) {
  std::mt19937 random(seed);
  for (int n = 0; n < instances; ++n) {
    const unsigned most = n % 20 == 0 ? 90 : n % 4 == 0 ? 40 : 15;
    const std::size_t rows = 1 + random() % most;
    const std::size_t cols = 1 + random() % most;
    const bool closed = random() % 2 == 0;
    const SkewTable<V> table = random_table<V>(random, rows, cols, closed);
    StepRule<V> rule;
    if (random() % 2 == 0) rule = {random() % 2 == 0, static_cast<V>(random() % 3)};
    const PathFamily<V> family{&table, static_cast<int>(rows) + 1, !closed, rule};
    V expected = kUnreachable<V>;
    int start = -1;
    for (int k = 0; k < static_cast<int>(rows); ++k) {
      const V cost = plain_cost(family, k);
      if (cost < expected) {
        expected = cost;
        start = k;
      }
    }
    const auto best = StartFamily<V>(family, 1).best({});
    ASSERT_EQ(best.cost, expected) << rows << " x " << cols;
    ASSERT_EQ(best.start, start) << rows << " x " << cols;
    const TracedCost<V> traced = trace_path(family, start, {});
    ASSERT_EQ(traced.cost, expected);
    ASSERT_EQ(cost_along(family, traced.nodes), expected);
    ASSERT_EQ(traced.nodes.front(), (Node{start, 0}));
    ASSERT_EQ(traced.nodes.back(), (Node{start + static_cast<int>(rows), table.width() - 1}));
  }
}

TEST(ThreeStepKernels, RealCostsEqualThePlainProgramme) {
  check_random_families<double>(1, 5000);
}

TEST(ThreeStepKernels, FixedCostsEqualThePlainProgramme) {
  check_random_families<std::int32_t>(2, 5000);
}

TEST(ThreeStepKernels, EveryInstructionSetIsExact) {
  for_each_instruction_set([](const char* name) {
    SCOPED_TRACE(name);
    check_random_families<double>(3, 1000);
    check_random_families<std::int32_t>(4, 1000);
  });
}

/// Ties are settled alike in tables of any size: diagonal first, then left.
TEST(ThreeStepKernels, TiesGoDiagonalThenLeft) {
  const SkewTable<std::int32_t> table(40, 60);
  const PathFamily<std::int32_t> family{&table, 40, true, {}};
  const std::vector<Node> nodes = trace_path(family, 0, {}).nodes;
  ASSERT_EQ(nodes.size(), 60u);
  // From the end backwards: 39 diagonal steps, then along row 0.
  for (int n = 0; n < 60; ++n) EXPECT_EQ(nodes[static_cast<std::size_t>(n)], (Node{std::max(0, n - 20), n}));
}

detail::TangentPlanes random_tangents(std::mt19937& random, std::size_t n, std::size_t dim) {
  detail::TangentPlanes t{std::vector<std::vector<double>>(dim, std::vector<double>(n))};
  const std::size_t plateau = 1 + random() % 4;
  for (std::size_t i = 0; i < n; ++i) {
    double square = 0.0;
    for (std::size_t c = 0; c < dim; ++c) {
      t.planes[c][i] =
          i % plateau == 0 ? static_cast<double>(random() % 2001) / 1000.0 - 1.0 + 1e-9 : t.planes[c][i - 1];
      square += t.planes[c][i] * t.planes[c][i];
    }
    if (i % plateau != 0) continue;
    for (std::size_t c = 0; c < dim; ++c) t.planes[c][i] /= std::sqrt(square);
  }
  return t;
}

double tangent_cost(const detail::TangentPlanes& a, const detail::TangentPlanes& b, std::size_t i,
                    std::size_t j) {
  double dot = 0.0;
  for (std::size_t c = 0; c < a.planes.size(); ++c) dot += a.planes[c][i] * b.planes[c][j];
  return std::max(0.0, 1.0 - dot);
}

TEST(FixedCosts, AreWithinHalfAQuantum) {
  std::mt19937 random(5);
  for (int n = 0; n < 200; ++n) {
    const std::size_t dim = 1 + random() % 4;
    const auto a = random_tangents(random, 1 + random() % 40, dim);
    const auto b = random_tangents(random, 1 + random() % 40, dim);
    const FixedCosts fixed = fixed_tangent_costs(a, b, true);
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j <= b.size(); ++j) {
        const double cost = tangent_cost(a, b, i, j % b.size());
        ASSERT_NEAR(fixed.table.at(i, j) * fixed.quantum, cost, 0.5 * fixed.quantum + 1e-15);
      }
    }
  }
}

/// The path that is optimal in fixed point, counted in doubles, is within the stated bound of the optimum.
TEST(FixedCosts, LoseNoMoreThanTheyState) {
  std::mt19937 random(6);
  for (int n = 0; n < 8000; ++n) {
    const unsigned most = n % 20 == 0 ? 60 : 16;
    const auto a = random_tangents(random, 1 + random() % most, 2);
    const auto b = random_tangents(random, 1 + random() % most, 2);
    NodeTable table{a.size(), b.size(), {}, {}};
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) {
        table.cost.push_back(tangent_cost(a, b, i, j));
        table.invalid.push_back(0);
      }
    }
    const Path exact = closed_path(table);
    const FixedCosts fixed = fixed_tangent_costs(a, b, true);
    const PathFamily<std::int32_t> family{&fixed.table, static_cast<int>(a.size()) + 1, false, {}};
    const auto best = StartFamily<std::int32_t>(family, 1).best({});
    const std::vector<Node> nodes = trace_path(family, best.start, {}).nodes;
    double rescored = 0.0;
    for (std::size_t k = 1; k < nodes.size(); ++k) {
      rescored += table.cost[table.index(static_cast<std::size_t>(nodes[k].i) % table.rows,
                                         static_cast<std::size_t>(nodes[k].j) % table.cols)];
    }
    const double bound = static_cast<double>(a.size() + b.size()) * fixed.quantum;
    ASSERT_LE(rescored, exact.cost + bound);
    ASSERT_GE(rescored, exact.cost - 1e-12 * (1.0 + exact.cost));
    ASSERT_NEAR(best.cost * fixed.quantum, rescored, 0.5 * bound);
  }
}

/// A whole match: bit for bit the same on every instruction set and every number of threads.
TEST(ThreeStepKernels, MatchesAreTheSameEverywhere) {
  std::mt19937 random(8);
  for (const int m : {37, 400}) {
    const auto a = random_tangents(random, static_cast<std::size_t>(m), 2);
    const auto b = random_tangents(random, static_cast<std::size_t>(m) + 5, 2);
    NodeTable table{a.size(), b.size(), {}, {}};
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) {
        table.cost.push_back(tangent_cost(a, b, i, j));
        table.invalid.push_back(table.cost.back() > 1.0 ? 1 : 0);
      }
    }
    const Path closed = closed_path(table);
    const Path open = open_path(table);
    for_each_instruction_set([&](const char* name) {
      SCOPED_TRACE(name);
      for (const int threads : {1, 2, 4}) {
        const Path again = closed_path(table, Aggregate::sum, {}, threads);
        EXPECT_EQ(again.nodes, closed.nodes);
        EXPECT_EQ(again.cost, closed.cost);
      }
      EXPECT_EQ(open_path(table).nodes, open.nodes);
    });
  }
}

}  // namespace
}  // namespace tandem
