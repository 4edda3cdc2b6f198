#include "tandem/match/programme.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "match/brute_force.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using brute::Found;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Costs in eighths: sums are exact, and ties and plateaus abound.
NodeTable random_table(std::mt19937& random, int most) {
  NodeTable t;
  t.rows = 1 + random() % static_cast<unsigned>(most);
  t.cols = 1 + random() % static_cast<unsigned>(most);
  const unsigned levels = 1 + random() % 12;
  const unsigned invalid_odds = random() % 4;
  for (std::size_t k = 0; k < t.rows * t.cols; ++k) {
    t.cost.push_back(static_cast<double>(random() % levels) / 8.0);
    t.invalid.push_back(invalid_odds != 0 && random() % 4 < invalid_odds ? 1 : 0);
  }
  return t;
}

/// The path makes only allowed steps, and its costs are what the programme says.
void check_path(const NodeTable& t, const Path& path, Aggregate aggregate, bool count_start) {
  ASSERT_FALSE(path.nodes.empty());
  double cost = 0.0;
  std::int64_t invalid = 0;
  for (std::size_t n = 0; n < path.nodes.size(); ++n) {
    if (n > 0) {
      const int di = path.nodes[n].i - path.nodes[n - 1].i;
      const int dj = path.nodes[n].j - path.nodes[n - 1].j;
      EXPECT_TRUE((di == 0 || di == 1) && (dj == 0 || dj == 1) && di + dj > 0);
    }
    if (n == 0 && !count_start) continue;
    const std::size_t k = t.index(static_cast<std::size_t>(path.nodes[n].i) % t.rows,
                                  static_cast<std::size_t>(path.nodes[n].j) % t.cols);
    cost = brute::join(aggregate, cost, t.cost[k]);
    invalid += t.invalid[k];
  }
  EXPECT_EQ(cost, path.cost);
  EXPECT_EQ(invalid, path.invalid);
}

NodeTable figure5() {
  NodeTable t{4, 4, {.1, 0, .2, .4, .9, 0, .9, .2, .1, .3, .5, 0, 0, .2, 0, .4}, {}};
  t.invalid = {0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 1, 0, 1, 0};
  return t;
}

TEST(ThreeSteps, ReproduceFigure5) {
  const NodeTable t = figure5();
  const Path path = open_path(t);
  const std::vector<Node> expected = {{0, 0}, {1, 0}, {2, 1}, {2, 2}, {3, 3}};
  EXPECT_EQ(path.nodes, expected);
  EXPECT_NEAR(path.cost, 2.2, 1e-15);
  EXPECT_EQ(path.invalid, 0);
  const std::vector<double> cost = accumulated_costs(t);
  const std::vector<double> printed = {.1,  8.1, 8.3, 8.7, 1,   8.1, 9,   8.5,
                                       1.1, 1.3, 1.8, 9.8, 9.1, 1.3, 9.3, 2.2};
  for (std::size_t k = 0; k < printed.size(); ++k) EXPECT_NEAR(cost[k], printed[k], 1e-14) << "cell " << k;
}

TEST(ThreeSteps, OpenEqualsBruteForce) {
  std::mt19937 random(1);
  for (int n = 0; n < 1000; ++n) {
    const NodeTable t = random_table(random, 6);
    for (const Aggregate aggregate : {Aggregate::sum, Aggregate::maximum}) {
      const Found best = brute::open(t, aggregate);
      const Path path = open_path(t, aggregate);
      ASSERT_EQ(path.cost, best.cost);
      ASSERT_EQ(path.invalid, best.invalid);
      check_path(t, path, aggregate, true);
    }
  }
}

TEST(ThreeSteps, ClosedEqualsBruteForce) {
  std::mt19937 random(2);
  for (int n = 0; n < 1000; ++n) {
    const NodeTable t = random_table(random, 5);
    for (const Aggregate aggregate : {Aggregate::sum, Aggregate::maximum}) {
      const Found best = brute::closed(t, aggregate);
      const Path path = closed_path(t, aggregate);
      ASSERT_EQ(path.cost, best.cost);
      ASSERT_EQ(path.invalid, best.invalid);
      check_path(t, path, aggregate, false);
      EXPECT_EQ(path.nodes.back().i, path.nodes.front().i + static_cast<int>(t.rows));
      EXPECT_EQ(path.nodes.back().j, path.nodes.front().j + static_cast<int>(t.cols));
    }
  }
}

TEST(ThreeSteps, PinnedEqualsBruteForce) {
  std::mt19937 random(3);
  for (int n = 0; n < 1000; ++n) {
    const NodeTable t = random_table(random, 5);
    const Found best = brute::pinned(t, Aggregate::sum);
    const Path path = pinned_path(t);
    ASSERT_EQ(path.cost, best.cost);
    ASSERT_EQ(path.invalid, best.invalid);
    check_path(t, path, Aggregate::sum, true);
  }
}

TEST(ThreeSteps, CutEqualsBruteForce) {
  std::mt19937 random(8);
  for (int n = 0; n < 1000; ++n) {
    const NodeTable t = random_table(random, 5);
    const Found best = brute::cut(t, Aggregate::sum);
    const Path path = cut_path(t);
    ASSERT_EQ(path.cost, best.cost);
    ASSERT_EQ(path.invalid, best.invalid);
    check_path(t, path, Aggregate::sum, true);
  }
}

TEST(ThreeSteps, PaperPenaltySaysTheSameAsTheLexicographicOrder) {
  std::mt19937 random(4);
  for (int n = 0; n < 1000; ++n) {
    NodeTable t = random_table(random, 7);
    t.cols = t.rows;
    t.cost.resize(t.rows * t.rows, 0.5);
    t.invalid.resize(t.rows * t.rows, 0);
    // [C]: a cost is at most 1, and the penalty stands in place of an invalid node's own.
    for (std::size_t k = 0; k < t.cost.size(); ++k)
      t.cost[k] = t.invalid[k] != 0 ? 0.0 : std::min(t.cost[k], 1.0);
    const double limit = 2.0 * static_cast<double>(t.rows);
    const Path path = open_path(t);
    EXPECT_EQ(accumulated_costs(t).back() >= limit, path.invalid > 0);
    EXPECT_NEAR(accumulated_costs(t).back(), path.cost + limit * static_cast<double>(path.invalid), 1e-12);
  }
}

TEST(ThreeSteps, InfiniteCostsBarNodes) {
  NodeTable t{2, 2, {1, kInfinity, kInfinity, 1}, {0, 0, 0, 0}};
  EXPECT_EQ(open_path(t).nodes, (std::vector<Node>{{0, 0}, {1, 1}}));
  t.cost[3] = kInfinity;
  EXPECT_TRUE(open_path(t).nodes.empty());
  EXPECT_TRUE(closed_path(NodeTable{1, 1, {kInfinity}, {0}}).nodes.empty());
}

TEST(ThreeSteps, RejectBadTables) {
  EXPECT_THROW((void)open_path(NodeTable{}), InvalidArgument);
  EXPECT_THROW((void)open_path(NodeTable{2, 2, {1, 1, 1}, {0, 0, 0}}), InvalidArgument);
  EXPECT_THROW((void)open_path(NodeTable{1, 1, {-1.0}, {0}}), InvalidArgument);
  EXPECT_THROW((void)closed_path(NodeTable{1, 1, {std::nan("")}, {0}}), InvalidArgument);
}

TEST(ThreeSteps, CancelWhenAsked) {
  std::mt19937 random(5);
  const NodeTable t = random_table(random, 5);
  EXPECT_TRUE(closed_path(t, Aggregate::sum, [](double) { return false; }).cancelled);
  EXPECT_TRUE(pinned_path(t, Aggregate::sum, [](double) { return false; }).cancelled);
}

// --- elastic ---

EdgeTable random_edges(std::mt19937& random, bool rows_cyclic, bool cols_cyclic, int most) {
  EdgeTable t;
  t.rows = 2 + random() % static_cast<unsigned>(most - 1);
  t.cols = 2 + random() % static_cast<unsigned>(most - 1);
  t.rows_cyclic = rows_cyclic;
  t.cols_cyclic = cols_cyclic;
  t.steps = coprime_steps(1 + static_cast<int>(random() % 6));
  const unsigned levels = 1 + random() % 12;
  const unsigned invalid_odds = random() % 4;
  const bool barred = random() % 2 == 0;
  for (std::size_t k = 0; k < t.rows * t.cols * t.steps.size(); ++k) {
    t.cost.push_back(barred && random() % 4 == 0 ? kInfinity : static_cast<double>(random() % levels) / 8.0);
    t.invalid.push_back(invalid_odds != 0 && random() % 4 < invalid_odds ? static_cast<double>(random() % 3)
                                                                         : 0.0);
  }
  return t;
}

TEST(ElasticProgramme, StepsAreCoprime) {
  EXPECT_EQ(coprime_steps(6).size(), 23u);
  EXPECT_EQ(coprime_steps(1), (std::vector<Step>{{1, 1}}));
  EXPECT_THROW((void)coprime_steps(0), InvalidArgument);
}

TEST(ElasticProgramme, OpenEqualsBruteForce) {
  std::mt19937 random(6);
  for (int n = 0; n < 1000; ++n) {
    const EdgeTable t = random_edges(random, false, false, 8);
    for (const Aggregate aggregate : {Aggregate::sum, Aggregate::maximum}) {
      const Found best = brute::open(t, aggregate);
      const Path path = open_path(t, aggregate);
      ASSERT_EQ(path.nodes.empty(), best.cost == kInfinity);
      if (path.nodes.empty()) continue;
      ASSERT_EQ(path.cost, best.cost);
      ASSERT_EQ(path.invalid, best.invalid);
    }
  }
}

TEST(ElasticProgramme, ClosedEqualsBruteForce) {
  std::mt19937 random(7);
  for (int n = 0; n < 1000; ++n) {
    const EdgeTable t = random_edges(random, true, true, 6);
    const int m1 = static_cast<int>(t.rows);
    const int m2 = static_cast<int>(t.cols);
    for (const Aggregate aggregate : {Aggregate::sum, Aggregate::maximum}) {
      const Found best = brute::closed(t, aggregate);
      const Path path = closed_path(t, aggregate);
      ASSERT_EQ(path.nodes.empty(), best.cost == kInfinity);
      if (path.nodes.empty()) continue;
      ASSERT_EQ(path.cost, best.cost);
      ASSERT_EQ(path.invalid, best.invalid);
      EXPECT_EQ(path.nodes.back().i, path.nodes.front().i + m1);
      EXPECT_EQ(path.nodes.back().j, path.nodes.front().j + m2);
    }
  }
}

TEST(ElasticProgramme, CutEqualsBruteForce) {
  std::mt19937 random(9);
  for (int n = 0; n < 1000; ++n) {
    const EdgeTable t = random_edges(random, true, false, 6);
    for (const Aggregate aggregate : {Aggregate::sum, Aggregate::maximum}) {
      const Found best = brute::cut(t, aggregate);
      const Path path = cut_path(t, aggregate);
      ASSERT_EQ(path.nodes.empty(), best.cost == kInfinity);
      if (path.nodes.empty()) continue;
      ASSERT_EQ(path.cost, best.cost);
      ASSERT_EQ(path.invalid, best.invalid);
    }
  }
}

}  // namespace
}  // namespace tandem
