#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "match/lexicographic.h"
#include "match/start_search.h"
#include "tandem/error.h"
#include "tandem/match/programme.h"

namespace tandem {
inline namespace v0 {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Where a cell's path comes from: the step that led there, or the start of its path. As wide as a double, so
/// that the relaxation below is one loop over equal lanes.
using Tag = std::int64_t;

/// Cells of the programme, by row; three parallel arrays for the same reason.
struct Cells {
  Cells(int rows, int cols)
      : width(static_cast<std::size_t>(cols)),
        invalid(static_cast<std::size_t>(rows) * width, kInfinity),
        cost(invalid.size(), kInfinity),
        tag(invalid.size(), -1) {}

  [[nodiscard]] std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i) * width + static_cast<std::size_t>(j);
  }
  [[nodiscard]] LexCost at(int i, int j) const { return {invalid[index(i, j)], cost[index(i, j)]}; }
  void start(int i, int j, Tag t) {
    const std::size_t k = index(i, j);
    invalid[k] = 0.0;
    cost[k] = 0.0;
    tag[k] = t;
  }

  std::size_t width;
  std::vector<double> invalid;
  std::vector<double> cost;
  std::vector<Tag> tag;
};

/// n neighbouring cells `to` relaxed over one step from n neighbouring cells `from`. Strictly better paths
/// only, so earlier steps win ties; an infinite cost bars the edge, whatever its invalidity.
template <class Join, bool kInheritTag>
void relax(Cells& cells, std::size_t from, std::size_t to, const double* edge_invalid,
           const double* edge_cost, std::size_t n, Tag step) {
  const double* from_invalid = cells.invalid.data() + from;
  const double* from_cost = cells.cost.data() + from;
  const Tag* from_tag = cells.tag.data() + from;
  double* to_invalid = cells.invalid.data() + to;
  double* to_cost = cells.cost.data() + to;
  Tag* to_tag = cells.tag.data() + to;
  for (std::size_t k = 0; k < n; ++k) {
    const double invalid = from_invalid[k] + edge_invalid[k];
    const double cost = Join::join(from_cost[k], edge_cost[k]);
    const bool better =
        (cost < kInfinity) & ((invalid < to_invalid[k]) | ((invalid == to_invalid[k]) & (cost < to_cost[k])));
    to_invalid[k] = better ? invalid : to_invalid[k];
    to_cost[k] = better ? cost : to_cost[k];
    to_tag[k] = better ? (kInheritTag ? from_tag[k] : step) : to_tag[k];
  }
}

/// Steps in the order of their preference on ties: nearest the diagonal first, then the smaller a.
std::vector<std::size_t> tie_order(const std::vector<Step>& steps) {
  std::vector<std::size_t> order(steps.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
    const Step& p = steps[x];
    const Step& q = steps[y];
    const int lhs = std::abs(p.a - p.b) * (q.a + q.b);
    const int rhs = std::abs(q.a - q.b) * (p.a + p.b);
    return lhs != rhs ? lhs < rhs : p.a < q.a;
  });
  return order;
}

class Programme {
 public:
  explicit Programme(const EdgeTable& table)
      : table_(table),
        rows_(static_cast<int>(table.rows)),
        cols_(static_cast<int>(table.cols)),
        order_(tie_order(table.steps)) {
    for (const Step& s : table.steps) longest_ = std::max({longest_, s.a, s.b});
  }

  /// Starts of a closed path are numbered k * starts_per_row() + l for the node (k,l).
  [[nodiscard]] int starts_per_row() const { return table_.cols_cyclic ? std::min(longest_, cols_) : 1; }
  [[nodiscard]] int start_count() const { return rows_ * starts_per_row(); }

  template <class Join>
  [[nodiscard]] std::vector<StartBound> bound_starts(int first, int last) const {
    const int per_row = starts_per_row();
    const int first_row = first / per_row;
    const int last_row = (last - 1) / per_row;
    Cells cells(last_row - first_row + rows_ + 1, advance() + per_row);
    for (int i = 0; i <= last_row - first_row + rows_; ++i) {
      for (int l = 0; l < per_row; ++l) {
        const int start = (first_row + i) * per_row + l;
        if (start >= first && start < last) cells.start(i, l, start);
      }
      // No path is led through the columns of the starts: every closed path is counted once, at the last of
      // its nodes that lies there.
      relax_row<Join, true>(cells, first_row, i, per_row);
    }
    std::vector<StartBound> bounds;
    bounds.reserve(static_cast<std::size_t>(last - first));
    for (int start = first; start < last; ++start) {
      const int i = start / per_row - first_row + rows_;
      const int j = start % per_row + advance();
      bounds.push_back({cells.at(i, j), static_cast<int>(cells.tag[cells.index(i, j)])});
    }
    return bounds;
  }

  /// The optimal path from node (k,l) to (k + height - 1, l + width - 1).
  template <class Join>
  [[nodiscard]] Path trace(int k, int l, int height, int width) const {
    Cells cells(height, l + width);
    cells.start(0, l, -1);
    for (int i = 1; i < height; ++i) relax_row<Join, false>(cells, k, i, 0);
    Path path;
    int i = height - 1;
    int j = l + width - 1;
    const LexCost best = cells.at(i, j);
    if (!(best < LexCost::infinite())) return path;
    path.cost = best.cost;
    path.invalid = static_cast<std::int64_t>(best.invalid);
    for (;;) {
      path.nodes.push_back({k + i, j});
      const Tag tag = cells.tag[cells.index(i, j)];
      if (tag < 0) break;
      const Step& step = table_.steps[static_cast<std::size_t>(tag)];
      i -= step.a;
      j -= step.b;
    }
    std::reverse(path.nodes.begin(), path.nodes.end());
    return path;
  }

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int cols() const { return cols_; }
  /// Columns from the start of a whole path to its end.
  [[nodiscard]] int advance() const { return table_.cols_cyclic ? cols_ : cols_ - 1; }

 private:
  /// Relaxes the cells of row i, from column first_col on, over all steps; cell rows count from table row
  /// first_row.
  template <class Join, bool kInheritTag>
  void relax_row(Cells& cells, int first_row, int i, int first_col) const {
    const auto row = static_cast<std::size_t>((first_row + i) % rows_);
    const int width = static_cast<int>(cells.width);
    for (std::size_t s : order_) {
      const Step step = table_.steps[s];
      if (step.a > i) continue;
      // Unrolled columns run over the table's more than once; each lap is one stretch of equal lanes.
      for (int lap = 0; lap < width; lap += cols_) {
        const int from = std::max({lap, step.b, first_col});
        const int to = std::min(lap + cols_, width);
        if (from >= to) continue;
        const std::size_t edge = table_.index(row, s, static_cast<std::size_t>(from - lap));
        relax<Join, kInheritTag>(cells, cells.index(i - step.a, from - step.b), cells.index(i, from),
                                 table_.invalid.data() + edge, table_.cost.data() + edge,
                                 static_cast<std::size_t>(to - from), static_cast<Tag>(s));
      }
    }
  }

  const EdgeTable& table_;
  int rows_;
  int cols_;
  int longest_ = 1;
  std::vector<std::size_t> order_;
};

template <class Join>
Path best_open(const EdgeTable& table) {
  const Programme programme(table);
  return programme.trace<Join>(0, 0, programme.rows(), programme.cols());
}

template <class Join>
Path best_start(const EdgeTable& table, const Progress& progress, LexCost limit) {
  const Programme programme(table);
  const StartChoice choice = search_starts(
      programme.start_count(), [&](int first, int last) { return programme.bound_starts<Join>(first, last); },
      progress, limit);
  if (choice.cancelled || choice.start < 0) {
    Path none;
    none.cancelled = choice.cancelled;
    return none;
  }
  const int per_row = programme.starts_per_row();
  return programme.trace<Join>(choice.start / per_row, choice.start % per_row, programme.rows() + 1,
                               programme.advance() + 1);
}

void check_table(const EdgeTable& table, bool rows_cyclic, bool cols_cyclic) {
  const std::size_t size = table.rows * table.cols * table.steps.size();
  if (size == 0 || table.cost.size() != size || table.invalid.size() != size) {
    throw InvalidArgument("an edge table needs rows * cols * steps > 0 costs and as many invalid lengths");
  }
  if (table.rows_cyclic != rows_cyclic || table.cols_cyclic != cols_cyclic) {
    throw InvalidArgument(
        "the edge table is cyclic where the programme wants it open, or the other way round");
  }
  for (double c : table.cost) {
    if (!(c >= 0.0)) throw InvalidArgument("an edge cost is negative or not a number");
  }
  for (const Step& s : table.steps) {
    if (s.a < 1 || s.b < 1) throw InvalidArgument("a step must advance on both curves");
  }
}

/// The table with every edge that costs more than `threshold` barred.
EdgeTable bar_above(EdgeTable table, double threshold) {
  for (double& c : table.cost) {
    if (c > threshold) c = kInfinity;
  }
  return table;
}

/// `find(table, join, limit)` for sums; for Aggregate::maximum twice: the least maximum first, then the least
/// sum among the paths that stay below it.
template <class Find>
Path aggregate_path(const EdgeTable& table, Aggregate aggregate, const Path* beat, const Find& find) {
  const LexCost limit = beat == nullptr || beat->nodes.empty()
                            ? LexCost::infinite()
                            : LexCost{static_cast<double>(beat->invalid), beat->cost};
  if (aggregate == Aggregate::sum) return find(table, SumCosts{}, limit);
  Path widest = find(table, MaxCosts{}, limit);
  if (widest.cancelled || widest.nodes.empty()) return widest;
  Path path = find(bar_above(table, widest.cost), SumCosts{}, LexCost::infinite());
  path.cost = widest.cost;
  return path;
}

}  // namespace

std::vector<Step> coprime_steps(int longest) {
  if (longest < 1) throw InvalidArgument("the longest step must be at least 1");
  std::vector<Step> steps;
  for (int a = 1; a <= longest; ++a) {
    for (int b = 1; b <= longest; ++b) {
      if (std::gcd(a, b) == 1) steps.push_back({a, b});
    }
  }
  return steps;
}

Path open_path(const EdgeTable& table, Aggregate aggregate) {
  check_table(table, false, false);
  return aggregate_path(table, aggregate, nullptr,
                        [](const EdgeTable& t, auto join, LexCost) { return best_open<decltype(join)>(t); });
}

Path closed_path(const EdgeTable& table, Aggregate aggregate, const Progress& progress, const Path* beat) {
  check_table(table, true, true);
  return aggregate_path(table, aggregate, beat, [&](const EdgeTable& t, auto join, LexCost limit) {
    return best_start<decltype(join)>(t, progress, limit);
  });
}

Path cut_path(const EdgeTable& table, Aggregate aggregate, const Progress& progress, const Path* beat) {
  check_table(table, true, false);
  return aggregate_path(table, aggregate, beat, [&](const EdgeTable& t, auto join, LexCost limit) {
    return best_start<decltype(join)>(t, progress, limit);
  });
}

}  // namespace v0
}  // namespace tandem
