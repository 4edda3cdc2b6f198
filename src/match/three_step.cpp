#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "match/lexicographic.h"
#include "match/relax_strip.h"
#include "match/start_search.h"
#include "tandem/error.h"
#include "tandem/match/programme.h"

namespace tandem {
inline namespace v0 {

namespace {

using detail::extend;
using detail::infinite_like;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A rectangle of the table unrolled in both directions; indices are taken modulo the table's size.
struct Window {
  int first_row = 0;
  int first_col = 0;
  int rows = 0;
  int cols = 0;
};

/// The node costs as a programme reads them, in type V: LexCost, or double, where an invalid node costs a
/// penalty above anything that valid nodes can add up to. The penalty makes sums of doubles lexicographic:
/// the count of invalid nodes exactly, the costs to rounding at the size of the penalties ([C]'s own way:
/// Cost >= 2m). It is a power of two.
template <class V>
class Nodes {
 public:
  Nodes(const NodeTable& table, double most, double threshold)
      : table_(table),
        rows_(static_cast<int>(table.rows)),
        cols_(static_cast<int>(table.cols)),
        threshold_(threshold) {
    // A closed path has at most rows + cols nodes.
    const double total = most * static_cast<double>(table.rows + table.cols);
    penalty_ = std::scalbn(1.0, std::ilogb(std::max(total, 1e-300)) + 1);
  }

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int cols() const { return cols_; }

  /// Columns first .. first + n - 1 of unrolled row i, into `out`.
  void unroll(int i, int first, int n, V* out) const {
    const std::size_t row = table_.index(static_cast<std::size_t>(i % rows_), 0);
    for (int j = first % cols_; n > 0; j = 0) {
      const auto lap = static_cast<std::size_t>(std::min(n, cols_ - j));
      const double* cost = table_.cost.data() + row + j;
      const std::uint8_t* invalid = table_.invalid.data() + row + j;
      for (std::size_t k = 0; k < lap; ++k) out[k] = value(cost[k], invalid[k], V{});
      out += lap;
      n -= static_cast<int>(lap);
    }
  }

 private:
  [[nodiscard]] double value(double cost, std::uint8_t invalid, double) const {
    const double counted = cost + (invalid != 0 ? penalty_ : 0.0);
    return cost <= threshold_ ? counted : kInfinity;
  }
  [[nodiscard]] LexCost value(double cost, std::uint8_t invalid, LexCost) const {
    if (cost > threshold_ || cost == kInfinity) return LexCost::infinite();
    return {static_cast<double>(invalid), cost};
  }

  const NodeTable& table_;
  int rows_;
  int cols_;
  double threshold_;  ///< nodes that cost more are barred
  double penalty_;
};

bool reaches(double cost) {
  return cost < kInfinity;
}
bool reaches(LexCost cost) {
  return cost.cost < kInfinity;
}

std::vector<Node> backtrack(const Window& w, const std::vector<std::uint8_t>& moves) {
  std::vector<Node> nodes;
  int i = w.rows - 1;
  int j = w.cols - 1;
  nodes.push_back({w.first_row + i, w.first_col + j});
  while (i > 0 || j > 0) {
    const std::uint8_t move =
        moves[static_cast<std::size_t>(i) * static_cast<std::size_t>(w.cols) + static_cast<std::size_t>(j)];
    if (move != detail::kLeft) --i;
    if (move != detail::kUp) --j;
    nodes.push_back({w.first_row + i, w.first_col + j});
  }
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

template <class V>
struct TracedPath {
  std::vector<Node> nodes;
  V cost = infinite_like(V{});
  bool cancelled = false;
};

/// The optimal path from a window's first node to its last. On a closed path the first node's own cost does
/// not count: it is the last node too.
template <class Join, class V>
TracedPath<V> trace_window(const Nodes<V>& nodes, const Window& w, bool count_start) {
  using detail::kStripRows;
  const auto rows = static_cast<std::size_t>(w.rows);
  const auto cols = static_cast<std::size_t>(w.cols);
  std::vector<V> above(cols, infinite_like(V{}));
  std::vector<V> strip(kStripRows * cols);
  std::vector<std::uint8_t> moves(rows * cols);
  std::array<const V*, kStripRows> strip_rows;
  for (std::size_t r = 0; r < kStripRows; ++r) strip_rows[r] = strip.data() + r * cols;
  for (std::size_t i = 0; i < rows; i += kStripRows) {
    const std::size_t count = std::min(kStripRows, rows - i);
    for (std::size_t r = 0; r < count; ++r) {
      nodes.unroll(w.first_row + static_cast<int>(i + r), w.first_col, w.cols, strip.data() + r * cols);
    }
    if (i == 0 && !count_start) strip[0] = V{};
    // The first node is entered by a diagonal from a node before it that costs nothing.
    detail::relax_strip<Join>(strip_rows, count, cols, above, i == 0 ? V{} : infinite_like(V{}),
                              moves.data() + i * cols);
  }
  TracedPath<V> traced;
  if (!reaches(above.back())) return traced;
  traced.cost = above.back();
  traced.nodes = backtrack(w, moves);
  return traced;
}

/// One row of the programme that starts at many nodes, with the start that each cell's path comes from.
template <class V>
struct OriginRow {
  explicit OriginRow(std::size_t width) : cost(width, infinite_like(V{})), origin(width, -1) {}
  std::vector<V> cost;
  std::vector<int> origin;
};

LexCost as_lex(double cost) {
  return {0.0, cost};
}
LexCost as_lex(LexCost cost) {
  return cost;
}

/// Bounds for the starts (k,0), first <= k < last, of the toroidal form: one programme from all of them.
template <class Join, class V>
std::vector<StartBound> bound_starts(const Nodes<V>& nodes, int first, int last) {
  const int m1 = nodes.rows();
  const auto width = static_cast<std::size_t>(nodes.cols()) + 1;
  OriginRow<V> above(width);
  OriginRow<V> row(width);
  std::vector<V> values(width);
  std::vector<StartBound> bounds(static_cast<std::size_t>(last - first));
  for (int i = first; i < last + m1; ++i) {
    nodes.unroll(i, 0, static_cast<int>(width), values.data());
    // A start costs nothing yet: its node is the end node too, where it is counted.
    const bool starts = i < last;
    row.cost[0] = starts ? V{} : extend<Join>(above.cost[0], values[0]);
    row.origin[0] = starts ? i : above.origin[0];
    for (std::size_t j = 1; j < width; ++j) {
      V best = above.cost[j - 1];
      int from = above.origin[j - 1];
      if (row.cost[j - 1] < best) {
        best = row.cost[j - 1];
        from = row.origin[j - 1];
      }
      if (above.cost[j] < best) {
        best = above.cost[j];
        from = above.origin[j];
      }
      row.cost[j] = extend<Join>(best, values[j]);
      row.origin[j] = from;
    }
    const V end = row.cost[width - 1];
    if (i >= first + m1 && reaches(end)) {
      bounds[static_cast<std::size_t>(i - m1 - first)] = {as_lex(end), row.origin[width - 1]};
    }
    std::swap(above, row);
  }
  return bounds;
}

template <class Join, class V>
TracedPath<V> best_closed(const Nodes<V>& nodes, const Progress& progress) {
  const StartChoice choice = search_starts(
      nodes.rows(), [&](int first, int last) { return bound_starts<Join>(nodes, first, last); }, progress);
  if (choice.cancelled || choice.start < 0) {
    TracedPath<V> none;
    none.cancelled = choice.cancelled;
    return none;
  }
  return trace_window<Join>(nodes, {choice.start, 0, nodes.rows() + 1, nodes.cols() + 1}, false);
}

/// The best of `count` windows, each with a programme of its own; the first one on a tie.
template <class Join, class V, class WindowAt>
TracedPath<V> best_window(const Nodes<V>& nodes, int count, const WindowAt& window_at,
                          const Progress& progress) {
  TracedPath<V> best;
  for (int k = 0; k < count; ++k) {
    if (progress && !progress(static_cast<double>(k) / count)) {
      best.cancelled = true;
      return best;
    }
    TracedPath<V> traced = trace_window<Join>(nodes, window_at(k), true);
    if (traced.cost < best.cost) best = std::move(traced);
  }
  return best;
}

/// The largest finite cost. @throws InvalidArgument the table's sizes disagree, or a cost is no cost
double check_table(const NodeTable& table) {
  if (table.rows == 0 || table.cols == 0 || table.cost.size() != table.rows * table.cols ||
      table.invalid.size() != table.cost.size()) {
    throw InvalidArgument("a cost table needs rows * cols > 0 costs and as many validity flags");
  }
  double most = 0.0;
  bool sound = true;
  for (double c : table.cost) {
    sound &= c >= 0.0;
    most = c > most && c < kInfinity ? c : most;
  }
  if (!sound) throw InvalidArgument("a node cost is negative or not a number");
  return most;
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

/// Runs find(nodes, join). For Aggregate::maximum twice: the least maximum first, then the least sum among
/// the paths that stay below it. closed: the start does not count.
template <class Find>
Path aggregate_path(const NodeTable& table, Aggregate aggregate, bool closed, const Find& find) {
  const double most = check_table(table);
  double threshold = kInfinity;
  if (aggregate == Aggregate::maximum) {
    const TracedPath<LexCost> widest = find(Nodes<LexCost>(table, most, kInfinity), MaxCosts{});
    if (widest.cancelled || widest.nodes.empty()) {
      Path none;
      none.cancelled = widest.cancelled;
      return none;
    }
    threshold = widest.cost.cost;
  }
  TracedPath<double> found = find(Nodes<double>(table, most, threshold), SumCosts{});
  Path path = rescored(std::move(found.nodes), table, aggregate, closed ? 1 : 0);
  path.cancelled = found.cancelled;
  return path;
}

}  // namespace

Path open_path(const NodeTable& table, Aggregate aggregate) {
  return aggregate_path(table, aggregate, false, [&](const auto& nodes, auto join) {
    return trace_window<decltype(join)>(nodes, {0, 0, nodes.rows(), nodes.cols()}, true);
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

Path closed_path(const NodeTable& table, Aggregate aggregate, const Progress& progress) {
  return aggregate_path(table, aggregate, true, [&](const auto& nodes, auto join) {
    return best_closed<decltype(join)>(nodes, progress);
  });
}

Path pinned_path(const NodeTable& table, Aggregate aggregate, const Progress& progress) {
  return aggregate_path(table, aggregate, false, [&](const auto& nodes, auto join) {
    return best_window<decltype(join)>(
        nodes, nodes.cols(),
        [&](int k) {
          return Window{0, k, nodes.rows(), nodes.cols()};
        },
        progress);
  });
}

Path cut_path(const NodeTable& table, Aggregate aggregate, const Progress& progress) {
  return aggregate_path(table, aggregate, false, [&](const auto& nodes, auto join) {
    return best_window<decltype(join)>(
        nodes, nodes.rows(),
        [&](int k) {
          return Window{k, 0, nodes.rows() + 1, nodes.cols()};
        },
        progress);
  });
}

}  // namespace v0
}  // namespace tandem
