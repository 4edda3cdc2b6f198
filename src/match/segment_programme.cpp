#include "match/segment_programme.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Paths within this share of the best one are as good: rounding tells them apart.
constexpr double kTie = 1e-13;

/// Starts that are still in question, and what a path from any of them costs at least.
struct Branch {
  double bound = 0.0;
  std::vector<Node> starts;  ///< by row

  friend bool operator<(const Branch& x, const Branch& y) { return x.bound > y.bound; }
};

class Search {
 public:
  Search(const SegmentArcs& arcs, double most)
      : arcs_(arcs),
        limit_(most),
        left_(arcs.cols_cyclic() ? std::max(0, arcs.longest_cols() - 1) : 0),
        width_(static_cast<std::size_t>(left_ + arcs.cols() + 1)) {}

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
    const int rows = arcs_.rows_cyclic() ? arcs_.rows() : 1;
    for (int i = 0; i < rows; ++i) {
      for (int p = 0; p <= left_; ++p) starts.push_back({i, -p});
    }
    return starts;
  }

  [[nodiscard]] Node end_of(const Node& start) const {
    return {start.i + arcs_.rows(), start.j + arcs_.cols()};
  }

  [[nodiscard]] std::size_t index(const Node& node) const {
    return static_cast<std::size_t>(node.i - first_row_) * width_ + static_cast<std::size_t>(node.j + left_);
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
    first_row_ = starts.front().i;
    const int last_row = starts.back().i + arcs_.rows();
    const std::size_t cells = static_cast<std::size_t>(last_row - first_row_ + 1) * width_;
    cost_.assign(cells, kInfinity);
    origin_.assign(cells, -1);
    arrival_.assign(cells, nullptr);
    for (std::size_t k = 0; k < starts.size(); ++k) {
      cost_[index(starts[k])] = 0.0;
      origin_[index(starts[k])] = static_cast<std::int32_t>(k);
    }
    const int rows = arcs_.rows();
    const int cols = arcs_.cols();
    for (int i = first_row_; i < last_row; ++i) {
      for (int j = -left_; j < cols; ++j) {
        const std::size_t at = index({i, j});
        const double cost = cost_[at];
        if (!(cost < limit_)) continue;
        const auto row = static_cast<std::size_t>(i % rows);
        const auto col = static_cast<std::size_t>(j < 0 ? j + cols : j);
        for (const SegmentArc& arc : arcs_.from(row, col)) {
          const Node next{i + arc.rows, j + arc.cols};
          if (next.i > last_row || next.j > cols) continue;
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
  double limit_;  ///< only paths that cost less are looked for
  int left_;      ///< columns before column 0 in which a path may start
  std::size_t width_;
  SegmentPath best_;
  // Of the last programme.
  int first_row_ = 0;
  std::vector<double> cost_;
  std::vector<std::int32_t> origin_;
  std::vector<const SegmentArc*> arrival_;
};

}  // namespace

SegmentPath best_segment_path(const SegmentArcs& arcs, double most, const Progress& progress) {
  return Search(arcs, most).run(progress);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
