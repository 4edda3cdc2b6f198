#include <algorithm>
#include <limits>
#include <utility>

#include "match/lexicographic_nodes.h"
#include "match/start_family.h"
#include "tandem/error.h"
#include "tandem/match/programme.h"

namespace tandem {
inline namespace v0 {

namespace {

using detail::LexicographicNodes;
using detail::PathFamily;
using detail::SkewTable;
using detail::StartFamily;
using detail::trace_open;
using detail::trace_path;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// @throws InvalidArgument the table's sizes disagree, or a cost is no cost
void check_table(const NodeTable& table) {
  if (table.rows == 0 || table.cols == 0 || table.cost.size() != table.rows * table.cols ||
      table.invalid.size() != table.cost.size()) {
    throw InvalidArgument("a cost table needs rows * cols > 0 costs and as many validity flags");
  }
  // Counted rather than looked for: a loop that never leaves early takes several costs at a time.
  std::size_t sound = 0;
  for (const double c : table.cost) sound += c >= 0.0 ? 1 : 0;
  if (sound != table.cost.size()) throw InvalidArgument("a node cost is negative or not a number");
}

/// The path with its cost and invalid nodes counted anew, without penalties. skip: nodes at its start that do
/// not count.
Path rescored(std::vector<Node> nodes, const NodeTable& table, Aggregate aggregate, std::size_t skip) {
  Path path;
  path.nodes = std::move(nodes);
  for (std::size_t n = 0; n < path.nodes.size(); ++n) {
    const std::size_t k = table.index(static_cast<std::size_t>(path.nodes[n].i) % table.rows,
                                      static_cast<std::size_t>(path.nodes[n].j) % table.cols);
    path.invalid_nodes.push_back(table.invalid[k]);
    if (n < skip) continue;
    path.cost = aggregate == Aggregate::sum ? path.cost + table.cost[k] : std::max(path.cost, table.cost[k]);
    path.invalid += table.invalid[k];
  }
  return path;
}

/// The optimal path for either aggregate from a programme for sums: find(threshold) is the best path whose
/// nodes cost at most the threshold. For the maximum, the least threshold that needs no more invalid nodes
/// than none at all is found by bisection among the costs that occur.
template <class Find>
Path with_aggregate(const NodeTable& table, Aggregate aggregate, const Find& find) {
  Path best = find(kInfinity);
  if (aggregate == Aggregate::sum || best.cancelled || best.nodes.empty()) return best;
  std::vector<double> thresholds;
  for (const double c : table.cost) {
    if (c <= best.cost) thresholds.push_back(c);
  }
  std::sort(thresholds.begin(), thresholds.end());
  thresholds.erase(std::unique(thresholds.begin(), thresholds.end()), thresholds.end());
  auto low = thresholds.begin();
  auto high = thresholds.end();
  while (low != high) {
    const auto middle = low + (high - low) / 2;
    Path path = find(*middle);
    if (path.cancelled) return path;
    if (!path.nodes.empty() && path.invalid == best.invalid) {
      best = std::move(path);
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return best;
}

/// A family of paths over all rows of a table, or over all its columns.
enum class Family { closed, cut, pinned };

SkewTable<double> skewed(const LexicographicNodes& nodes, Family family) {
  if (family == Family::pinned) {
    // The starts run along the rows of a skewed table.
    SkewTable<double> table(nodes.cols(), nodes.rows());
    for (std::size_t i = 0; i < nodes.rows(); ++i) {
      // Column i of all rows j: node (j,i) is in row (i + j) mod rows of the table.
      const std::size_t e = i % nodes.cols();
      const std::size_t before_wrap = nodes.cols() - e;
      nodes.copy(i, 0, before_wrap, table.diagonal(e) + i, table.stride());
      if (e > 0) nodes.copy(i, before_wrap, e, table.diagonal(0) + i, table.stride());
    }
    return table;
  }
  const bool closed = family == Family::closed;
  SkewTable<double> table(nodes.rows(), nodes.cols() + (closed ? 1 : 0));
  for (std::size_t i = 0; i < nodes.rows(); ++i) {
    table.set_row(i, [&](std::size_t first, std::size_t n, double* out, std::size_t stride) {
      const std::size_t inside = std::min(n, nodes.cols() - first);
      if (inside > 0) nodes.copy(i, first, inside, out, stride);
      // Column 0 again.
      if (inside < n) nodes.copy(i, 0, 1, out + inside * stride, stride);
    });
  }
  return table;
}

/// The path from the best start.
Path best_of_starts(const NodeTable& table, Family family, Aggregate aggregate, double threshold,
                    const Progress& progress, int threads) {
  const SkewTable<double> costs = skewed(LexicographicNodes(table, threshold), family);
  const bool closed = family == Family::closed;
  const bool pinned = family == Family::pinned;
  const PathFamily<double> paths{&costs, costs.rows() + (pinned ? 0 : 1), !closed, {}};
  const auto best = StartFamily<double>(paths, threads).best(progress);
  if (best.cancelled || best.start < 0) {
    Path none;
    none.cancelled = best.cancelled;
    return none;
  }
  std::vector<Node> nodes;
  if (pinned) {
    // In the table as it is, since ties are not settled alike in the transposed one.
    nodes = trace_open(LexicographicNodes(table, threshold, static_cast<std::size_t>(best.start))).nodes;
    for (Node& n : nodes) n.j += best.start;
  } else {
    nodes = trace_path(paths, best.start, {}).nodes;
  }
  return rescored(std::move(nodes), table, aggregate, closed ? 1 : 0);
}

Path best_of_starts(const NodeTable& table, Family family, Aggregate aggregate, const Progress& progress,
                    int threads) {
  check_table(table);
  return with_aggregate(table, aggregate, [&](double threshold) {
    return best_of_starts(table, family, aggregate, threshold, progress, threads);
  });
}

}  // namespace

Path open_path(const NodeTable& table, Aggregate aggregate) {
  check_table(table);
  return with_aggregate(table, aggregate, [&](double threshold) {
    return rescored(trace_open(LexicographicNodes(table, threshold)).nodes, table, aggregate, 0);
  });
}

std::vector<double> accumulated_costs(const NodeTable& table) {
  const double penalty = static_cast<double>(table.rows + table.cols);
  std::vector<double> cost(table.rows * table.cols);
  for (std::size_t i = 0; i < table.rows; ++i) {
    for (std::size_t j = 0; j < table.cols; ++j) {
      double best = i == 0 && j == 0 ? 0.0 : kInfinity;
      if (i > 0 && j > 0) best = cost[table.index(i - 1, j - 1)];
      if (j > 0) best = std::min(best, cost[table.index(i, j - 1)]);
      if (i > 0) best = std::min(best, cost[table.index(i - 1, j)]);
      const std::size_t k = table.index(i, j);
      cost[k] = best + (table.invalid[k] != 0 ? penalty : table.cost[k]);
    }
  }
  return cost;
}

Path closed_path(const NodeTable& table, Aggregate aggregate, const Progress& progress, int threads) {
  return best_of_starts(table, Family::closed, aggregate, progress, threads);
}

Path pinned_path(const NodeTable& table, Aggregate aggregate, const Progress& progress, int threads) {
  return best_of_starts(table, Family::pinned, aggregate, progress, threads);
}

Path cut_path(const NodeTable& table, Aggregate aggregate, const Progress& progress, int threads) {
  return best_of_starts(table, Family::cut, aggregate, progress, threads);
}

}  // namespace v0
}  // namespace tandem
