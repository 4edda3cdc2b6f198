#include "match/segment_programme.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <queue>
#include <span>
#include <utility>

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Paths within this share of the best one are as good: rounding tells them apart.
constexpr double kTie = 1e-13;

/// The columns before column 0 in which a closed path may start, to jump over it.
int columns_before(const SegmentArcs& arcs) {
  int most = 0;
  if (!arcs.cols_cyclic()) return most;
  for (int i = 0; i < arcs.rows(); ++i) {
    for (int p = most + 1; p < arcs.cols(); ++p) {
      const auto from = arcs.from(static_cast<std::size_t>(i), static_cast<std::size_t>(arcs.cols() - p));
      const auto jumps = [p](const SegmentArc& arc) { return arc.cols > p; };
      if (std::any_of(from.begin(), from.end(), jumps)) most = p;
    }
  }
  return most;
}

/// The nodes by row and column; columns run from -left to the last one, rows wrap where they are cyclic.
class Grid {
 public:
  explicit Grid(const SegmentArcs& arcs)
      : arcs_(arcs),
        left_(columns_before(arcs)),
        width_(static_cast<std::size_t>(left_ + arcs.cols() + 1)),
        rows_(arcs.rows() + (arcs.rows_cyclic() ? 0 : 1)) {}

  [[nodiscard]] int left() const { return left_; }
  [[nodiscard]] std::size_t width() const { return width_; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(rows_) * width_; }
  [[nodiscard]] std::size_t index(const Node& node) const {
    const int row = arcs_.rows_cyclic() ? node.i % arcs_.rows() : node.i;
    return static_cast<std::size_t>(row) * width_ + static_cast<std::size_t>(node.j + left_);
  }
  [[nodiscard]] std::span<const SegmentArc> arcs_from(const Node& node) const {
    return arcs_.from(static_cast<std::size_t>(node.i % arcs_.rows()),
                      static_cast<std::size_t>(node.j < 0 ? node.j + arcs_.cols() : node.j));
  }
  /// Whether a path may go from one node to the other: not past the end, and from before column 0 only over
  /// it.
  [[nodiscard]] bool allows(const Node& from, const Node& to) const {
    return to.j <= arcs_.cols() && (from.j >= 0 || to.j > 0) && (arcs_.rows_cyclic() || to.i <= arcs_.rows());
  }
  /// Rows in which a path may start.
  [[nodiscard]] int start_rows() const { return arcs_.rows_cyclic() ? arcs_.rows() : 1; }

 private:
  const SegmentArcs& arcs_;
  int left_;
  std::size_t width_;
  int rows_;
};

/// From every node, what the way to any end costs at least: the programme backwards.
std::vector<double> least_after(const Grid& grid, const SegmentArcs& arcs) {
  std::vector<double> least(grid.size(), kInfinity);
  for (int i = 0; i < grid.start_rows(); ++i) {
    for (int p = 0; p <= grid.left(); ++p) {
      least[grid.index({arcs.rows_cyclic() ? i : arcs.rows(), arcs.cols() - p})] = 0.0;
    }
  }
  for (int j = arcs.cols() - 1; j >= -grid.left(); --j) {
    for (int i = 0; i < arcs.rows(); ++i) {
      double& here = least[grid.index({i, j})];
      for (const SegmentArc& arc : grid.arcs_from({i, j})) {
        const Node next{i + arc.rows, j + arc.cols};
        if (grid.allows({i, j}, next)) here = std::min(here, arc.cost + least[grid.index(next)]);
      }
    }
  }
  return least;
}

/// To every node, what the way from any start costs at least.
std::vector<double> least_before(const Grid& grid, const SegmentArcs& arcs) {
  std::vector<double> least(grid.size(), kInfinity);
  for (int i = 0; i < grid.start_rows(); ++i) {
    for (int p = 0; p <= grid.left(); ++p) least[grid.index({i, -p})] = 0.0;
  }
  for (int j = -grid.left(); j < arcs.cols(); ++j) {
    for (int i = 0; i < arcs.rows(); ++i) {
      const double here = least[grid.index({i, j})];
      for (const SegmentArc& arc : grid.arcs_from({i, j})) {
        const Node next{i + arc.rows, j + arc.cols};
        if (!grid.allows({i, j}, next)) continue;
        double& there = least[grid.index(next)];
        there = std::min(there, here + arc.cost);
      }
    }
  }
  return least;
}

/// Drops the arcs that no path below `most` goes over.
void drop_dear_arcs(SegmentArcs& arcs, double most) {
  const Grid grid(arcs);
  const std::vector<double> before = least_before(grid, arcs);
  const std::vector<double> after = least_after(grid, arcs);
  arcs.filter([&](std::size_t row, std::size_t col, const SegmentArc& arc) {
    const auto cheap = [&](const Node& from) {
      const Node to{from.i + arc.rows, from.j + arc.cols};
      return grid.allows(from, to) && before[grid.index(from)] + arc.cost + after[grid.index(to)] < most;
    };
    const Node node{static_cast<int>(row), static_cast<int>(col)};
    return cheap(node) || (node.j - arcs.cols() >= -grid.left() && cheap({node.i, node.j - arcs.cols()}));
  });
}

/// Starts that are still in question, and what a path from any of them costs at least.
struct Branch {
  double bound = 0.0;
  std::vector<Node> starts;  ///< by column, then by row

  friend bool operator<(const Branch& x, const Branch& y) { return x.bound > y.bound; }
};

class Search {
 public:
  Search(const SegmentArcs& arcs, double most)
      : arcs_(arcs), grid_(arcs), least_after_(least_after(grid_, arcs)), limit_(most) {}

  SegmentPath run(const Progress& progress) {
    std::priority_queue<Branch> branches;
    branches.push({0.0, all_starts()});
    const auto total = static_cast<double>(branches.top().starts.size());
    double done = 0.0;
    while (!branches.empty() && branches.top().bound < limit_) {
      Branch branch = branches.top();
      branches.pop();
      const std::size_t before = branch.starts.size();
      std::vector<Branch> halves = settle(std::move(branch.starts));
      std::size_t left = 0;
      for (Branch& half : halves) {
        left += half.starts.size();
        branches.push(std::move(half));
      }
      done += static_cast<double>(before - left);
      if (progress && !progress(std::min(done / total, 1.0))) return {{}, 0.0, true};
    }
    return std::move(best_);
  }

 private:
  [[nodiscard]] std::vector<Node> all_starts() const {
    std::vector<Node> starts;
    for (int p = 0; p <= grid_.left(); ++p) {
      for (int i = 0; i < grid_.start_rows(); ++i) starts.push_back({i, -p});
    }
    return starts;
  }

  [[nodiscard]] Node end_of(const Node& start) const {
    return {start.i + arcs_.rows(), start.j + arcs_.cols()};
  }

  [[nodiscard]] std::size_t index(const Node& node) const {
    return static_cast<std::size_t>(node.i - first_row_) * grid_.width() +
           static_cast<std::size_t>(node.j + grid_.left());
  }

  /// Runs the programme from all of these starts, keeps the best path that is found, and returns the starts
  /// that may have a better one, in two halves.
  std::vector<Branch> settle(std::vector<Node> starts) {
    relax(starts);
    std::vector<std::pair<double, Node>> open;
    for (std::size_t k = 0; k < starts.size(); ++k) {
      const std::size_t end = index(end_of(starts[k]));
      if (!(cost_[end] < limit_)) continue;
      if (origin_[end] == static_cast<std::int32_t>(k)) {
        keep(starts[k]);
      } else {
        open.emplace_back(cost_[end], starts[k]);
      }
    }
    std::vector<Branch> halves;
    const std::size_t half = open.size() / 2;
    for (const auto& [from, to] : {std::pair(std::size_t{0}, half), std::pair(half, open.size())}) {
      Branch branch{kInfinity, {}};
      for (std::size_t k = from; k < to; ++k) {
        if (!(open[k].first < limit_)) continue;
        branch.bound = std::min(branch.bound, open[k].first);
        branch.starts.push_back(open[k].second);
      }
      if (!branch.starts.empty()) halves.push_back(std::move(branch));
    }
    return halves;
  }

  void relax(const std::vector<Node>& starts) {
    const auto [first, last] = std::minmax_element(starts.begin(), starts.end(),
                                                   [](const Node& x, const Node& y) { return x.i < y.i; });
    first_row_ = first->i;
    const int last_row = last->i + arcs_.rows();
    const int last_col = starts.front().j + arcs_.cols();
    const std::size_t cells = static_cast<std::size_t>(last_row - first_row_ + 1) * grid_.width();
    cost_.assign(cells, kInfinity);
    origin_.assign(cells, -1);
    arrival_.assign(cells, nullptr);
    for (std::size_t k = 0; k < starts.size(); ++k) {
      cost_[index(starts[k])] = 0.0;
      origin_[index(starts[k])] = static_cast<std::int32_t>(k);
    }
    for (int i = first_row_; i < last_row; ++i) {
      for (int j = -grid_.left(); j < arcs_.cols(); ++j) {
        const std::size_t at = index({i, j});
        const double cost = cost_[at];
        if (!(cost + least_after_[grid_.index({i, j})] < limit_)) continue;
        for (const SegmentArc& arc : grid_.arcs_from({i, j})) {
          const Node next{i + arc.rows, j + arc.cols};
          if (next.i > last_row || next.j > last_col || !grid_.allows({i, j}, next)) continue;
          const std::size_t to = index(next);
          const double sum = cost + arc.cost;
          // On a tie the arc over fewer segments.
          const bool shorter = sum == cost_[to] && arrival_[to] != nullptr &&
                               arc.rows + arc.cols < arrival_[to]->rows + arrival_[to]->cols;
          if (!(sum < cost_[to]) && !shorter) continue;
          cost_[to] = sum;
          origin_[to] = origin_[at];
          arrival_[to] = &arc;
        }
      }
    }
  }

  void keep(const Node& start) {
    Node node = end_of(start);
    best_.cost = cost_[index(node)];
    limit_ = best_.cost * (1.0 - kTie);
    best_.nodes = {node};
    while (!(node == start)) {
      const SegmentArc* arc = arrival_[index(node)];
      node = {node.i - arc->rows, node.j - arc->cols};
      best_.nodes.push_back(node);
    }
    std::reverse(best_.nodes.begin(), best_.nodes.end());
  }

  const SegmentArcs& arcs_;
  Grid grid_;
  std::vector<double> least_after_;
  double limit_;  ///< only paths that cost less are looked for
  SegmentPath best_;
  // Of the last programme.
  int first_row_ = 0;
  std::vector<double> cost_;
  std::vector<std::int32_t> origin_;
  std::vector<const SegmentArc*> arrival_;
};

/// Whether x is joint `pin` of an axis.
bool is_joint(int x, int pin, int size, bool cyclic) {
  return cyclic ? (x - pin) % size == 0 : x == pin;
}

/// Whether joint `pin` lies strictly between two joints.
bool jumps_over(int from, int to, int pin, int size, bool cyclic) {
  for (int x = from + 1; x < to; ++x) {
    if (is_joint(x, pin, size, cyclic)) return true;
  }
  return false;
}

}  // namespace

void keep_to_pins(SegmentArcs& arcs, std::span<const Node> pins) {
  const bool rows_cyclic = arcs.rows_cyclic();
  // Where a loop is cut to meet an open path, that path's two ends meet the same joint.
  const bool cols_cyclic = arcs.cols_cyclic() || rows_cyclic;
  const auto meets = [&](const Node& node, const Node& pin) {
    return is_joint(node.i, pin.i, arcs.rows(), rows_cyclic) ==
           is_joint(node.j, pin.j, arcs.cols(), cols_cyclic);
  };
  if (pins.empty()) return;
  // A path gets to every row and every column, unless an arc jumps over it.
  arcs.filter([&](std::size_t row, std::size_t col, const SegmentArc& arc) {
    const Node from{static_cast<int>(row), static_cast<int>(col)};
    const Node to{from.i + arc.rows, from.j + arc.cols};
    return std::all_of(pins.begin(), pins.end(), [&](const Node& pin) {
      return meets(from, pin) && meets(to, pin) &&
             !jumps_over(from.i, to.i, pin.i, arcs.rows(), rows_cyclic) &&
             !jumps_over(from.j, to.j, pin.j, arcs.cols(), cols_cyclic);
    });
  });
}

SegmentPath best_segment_path(SegmentArcs& arcs, double most, const Progress& progress) {
  if (most < kInfinity) drop_dear_arcs(arcs, most);
  return Search(arcs, most).run(progress);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
