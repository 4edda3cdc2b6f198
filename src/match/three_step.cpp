#include <algorithm>
#include <cmath>
#include <limits>

#include "match/lexicographic.h"
#include "match/start_search.h"
#include "tandem/error.h"
#include "tandem/match/programme.h"

namespace tandem {
inline namespace v0 {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum Move : std::uint8_t { kStart, kDiagonal, kLeft, kUp };

/// A rectangle of the table unrolled in both directions; indices are taken modulo the table's size.
struct Window {
  int first_row = 0;
  int first_col = 0;
  int rows = 0;
  int cols = 0;
};

/// The table as the programmes read it. Nodes that cost more than the threshold, or infinity, are barred.
class Nodes {
 public:
  Nodes(const NodeTable& table, double threshold) : table_(table), threshold_(threshold) {}

  [[nodiscard]] int rows() const { return static_cast<int>(table_.rows); }
  [[nodiscard]] int cols() const { return static_cast<int>(table_.cols); }
  /// Offset of unrolled row i.
  [[nodiscard]] std::size_t row(int i) const { return static_cast<std::size_t>(i % rows()) * table_.cols; }
  [[nodiscard]] LexCost at(std::size_t row, int j) const {
    const std::size_t k = row + static_cast<std::size_t>(j < cols() ? j : j % cols());
    const double c = table_.cost[k];
    if (c > threshold_ || c == kInfinity) return LexCost::infinite();
    return {static_cast<double>(table_.invalid[k]), c};
  }

 private:
  const NodeTable& table_;
  double threshold_;
};

/// A row of the programme; cell j + 1 is column j of the window, cell 0 a sentinel.
using Row = std::vector<LexCost>;

/// One row, from column lo on, from the row above: [C] eq. (7) in lexicographic order. Ties: diagonal, left,
/// up.
template <class Join>
void relax_row(const Nodes& nodes, const Window& w, int i, int lo, const Row& above, Row& row,
               std::uint8_t* moves) {
  const std::size_t offset = nodes.row(w.first_row + i);
  for (int j = lo; j < w.cols; ++j) {
    const auto c = static_cast<std::size_t>(j) + 1;
    LexCost best = above[c - 1];
    std::uint8_t move = kDiagonal;
    if (row[c - 1] < best) {
      best = row[c - 1];
      move = kLeft;
    }
    if (above[c] < best) {
      best = above[c];
      move = kUp;
    }
    const LexCost node = nodes.at(offset, w.first_col + j);
    row[c] = {best.invalid + node.invalid, Join::join(best.cost, node.cost)};
    moves[j] = move;
  }
}

struct TracedPath {
  Path path;
  LexCost cost = LexCost::infinite();
};

Path backtrack(const Window& w, const std::vector<std::uint8_t>& moves) {
  Path path;
  int i = w.rows - 1;
  int j = w.cols - 1;
  for (;;) {
    path.nodes.push_back({w.first_row + i, w.first_col + j});
    const std::uint8_t move =
        moves[static_cast<std::size_t>(i) * static_cast<std::size_t>(w.cols) + static_cast<std::size_t>(j)];
    if (move == kStart) break;
    if (move != kLeft) --i;
    if (move != kUp) --j;
  }
  std::reverse(path.nodes.begin(), path.nodes.end());
  return path;
}

/// The optimal path from the window's first node to its last. On a closed path the first node's own cost does
/// not count: it is the last node too.
template <class Join>
TracedPath trace_window(const Nodes& nodes, const Window& w, bool count_start) {
  const auto cols = static_cast<std::size_t>(w.cols);
  Row above(cols + 1, LexCost::infinite());
  Row row(cols + 1, LexCost::infinite());
  std::vector<std::uint8_t> moves(static_cast<std::size_t>(w.rows) * cols, kStart);
  for (int i = 0; i < w.rows; ++i) {
    if (i == 0) row[1] = count_start ? nodes.at(nodes.row(w.first_row), w.first_col) : LexCost{};
    relax_row<Join>(nodes, w, i, i == 0 ? 1 : 0, above, row,
                    moves.data() + static_cast<std::size_t>(i) * cols);
    std::swap(above, row);
    row[0] = LexCost::infinite();
  }
  TracedPath traced;
  traced.cost = above[cols];
  if (!(traced.cost < LexCost::infinite())) return traced;
  traced.path = backtrack(w, moves);
  traced.path.cost = traced.cost.cost;
  traced.path.invalid = static_cast<std::int64_t>(traced.cost.invalid);
  return traced;
}

/// One row of the programme that starts at many nodes, with the start that each cell's path comes from.
struct OriginRow {
  explicit OriginRow(std::size_t width) : cost(width, LexCost::infinite()), origin(width, -1) {}
  std::vector<LexCost> cost;
  std::vector<int> origin;
};

/// Bounds for the starts (k,0), first <= k < last, of the toroidal form: one programme from all of them.
template <class Join>
std::vector<StartBound> bound_starts(const Nodes& nodes, int first, int last) {
  const int m1 = nodes.rows();
  const auto width = static_cast<std::size_t>(nodes.cols()) + 1;
  OriginRow above(width);
  OriginRow row(width);
  std::vector<StartBound> bounds(static_cast<std::size_t>(last - first));
  for (int i = first; i < last + m1; ++i) {
    const std::size_t offset = nodes.row(i);
    const auto enter = [&](std::size_t j, LexCost best, int from) {
      const LexCost node = nodes.at(offset, static_cast<int>(j));
      row.cost[j] = {best.invalid + node.invalid, Join::join(best.cost, node.cost)};
      row.origin[j] = from;
    };
    if (i < last) {
      // A start costs nothing yet: its node is the end node too, where it is counted.
      row.cost[0] = {};
      row.origin[0] = i;
    } else {
      enter(0, above.cost[0], above.origin[0]);
    }
    for (std::size_t j = 1; j < width; ++j) {
      LexCost best = above.cost[j - 1];
      int from = above.origin[j - 1];
      if (row.cost[j - 1] < best) {
        best = row.cost[j - 1];
        from = row.origin[j - 1];
      }
      if (above.cost[j] < best) {
        best = above.cost[j];
        from = above.origin[j];
      }
      enter(j, best, from);
    }
    if (i >= first + m1) {
      bounds[static_cast<std::size_t>(i - m1 - first)] = {row.cost[width - 1], row.origin[width - 1]};
    }
    std::swap(above, row);
  }
  return bounds;
}

template <class Join>
TracedPath best_closed(const Nodes& nodes, const Progress& progress) {
  const StartChoice choice = search_starts(
      nodes.rows(), [&](int first, int last) { return bound_starts<Join>(nodes, first, last); }, progress);
  if (choice.cancelled || choice.start < 0) {
    TracedPath none;
    none.path.cancelled = choice.cancelled;
    return none;
  }
  return trace_window<Join>(nodes, {choice.start, 0, nodes.rows() + 1, nodes.cols() + 1}, false);
}

/// The best of `count` windows, each with a programme of its own; the first one on a tie.
template <class Join, class WindowAt>
TracedPath best_window(const Nodes& nodes, int count, const WindowAt& window_at, const Progress& progress) {
  TracedPath best;
  for (int k = 0; k < count; ++k) {
    if (progress && !progress(static_cast<double>(k) / count)) {
      best.path.cancelled = true;
      return best;
    }
    TracedPath traced = trace_window<Join>(nodes, window_at(k), true);
    if (traced.cost < best.cost) best = std::move(traced);
  }
  return best;
}

void check_table(const NodeTable& table) {
  if (table.rows == 0 || table.cols == 0 || table.cost.size() != table.rows * table.cols ||
      table.invalid.size() != table.cost.size()) {
    throw InvalidArgument("a cost table needs rows * cols > 0 costs and as many validity flags");
  }
  for (double c : table.cost) {
    if (!(c >= 0.0)) throw InvalidArgument("a node cost is negative or not a number");
  }
}

/// Runs `find` once for sums; for Aggregate::maximum twice: the least maximum first, then the least sum among
/// the paths that stay below it.
template <class Find>
Path aggregate_path(const NodeTable& table, Aggregate aggregate, const Find& find) {
  check_table(table);
  if (aggregate == Aggregate::sum) return find(Nodes(table, kInfinity), SumCosts{}).path;
  const Path widest = find(Nodes(table, kInfinity), MaxCosts{}).path;
  if (widest.cancelled || widest.nodes.empty()) return widest;
  Path path = find(Nodes(table, widest.cost), SumCosts{}).path;
  path.cost = widest.cost;
  return path;
}

}  // namespace

Path open_path(const NodeTable& table, Aggregate aggregate) {
  return aggregate_path(table, aggregate, [&](const Nodes& nodes, auto join) {
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
  return aggregate_path(table, aggregate, [&](const Nodes& nodes, auto join) {
    return best_closed<decltype(join)>(nodes, progress);
  });
}

Path pinned_path(const NodeTable& table, Aggregate aggregate, const Progress& progress) {
  return aggregate_path(table, aggregate, [&](const Nodes& nodes, auto join) {
    return best_window<decltype(join)>(
        nodes, nodes.cols(),
        [&](int k) {
          return Window{0, k, nodes.rows(), nodes.cols()};
        },
        progress);
  });
}

Path cut_path(const NodeTable& table, Aggregate aggregate, const Progress& progress) {
  return aggregate_path(table, aggregate, [&](const Nodes& nodes, auto join) {
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
