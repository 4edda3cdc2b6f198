#include "match/search_pinned.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "match/candidates.h"
#include "match/elastic_programme.h"
#include "tandem/error.h"
#include "tandem/match/elastic.h"
#include "tandem/match/norm.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

int wrapped(int i, std::size_t n) {
  const int size = static_cast<int>(n);
  return (i % size + size) % size;
}

/// The node that was placed at parameter t.
int node_at(const Samples& s, double t) {
  std::size_t best = 0;
  double least = INFINITY;
  for (std::size_t k = 0; k < s.size(); ++k) {
    double gap = std::fabs(s.parameters[k] - t);
    if (s.cyclic) gap = std::min(gap, std::fabs(s.period - gap));
    if (gap < least) {
      least = gap;
      best = k;
    }
  }
  return static_cast<int>(best);
}

/// What the stretch of a curve from node `first` over `chords` chords needs of its samples to run a
/// programme.
Samples stretch_of(const Samples& s, int first, int chords) {
  Samples part;
  for (int k = 0; k <= chords; ++k) {
    part.parameters.push_back(s.parameters[static_cast<std::size_t>(wrapped(first + k, s.size()))]);
    if (k < chords) {
      part.chord_lengths.push_back(s.chord_lengths[static_cast<std::size_t>(wrapped(first + k, s.size()))]);
    }
  }
  return part;
}

/// Both curves as one programme sees them.
class Stretches {
 public:
  Stretches(const Samples& a, const Samples& b, const MatchOptions& options, RuledSign sign)
      : a_(a),
        b_(b),
        options_(options),
        elastic_(options.method != Method::paper),
        aggregate_(aggregate_of(options.norm)),
        table_(elastic_ ? chord_costs(a, b, options.norm, options.features, sign)
                        : node_costs(a, b, options.norm, options.features, sign)) {}

  /// The optimal path from one node to another.
  [[nodiscard]] Path between(const Node& from, const Node& to) const {
    const int rows = to.i - from.i;
    const int cols = to.j - from.j;
    if (rows < 0 || cols < 0) return {};
    Path path;
    if (elastic_ && (rows == 0 || cols == 0)) {
      if (rows == cols) path.nodes = {from};
      return path;
    }
    if (elastic_) {
      const NodeTable table = part(from, rows, cols);
      EdgeRows edges(stretch_of(a_, from.i, rows), stretch_of(b_, from.j, cols), table, options_.elastic,
                     aggregate_);
      path = best_elastic_path(edges, aggregate_, nullptr, {}, nullptr);
    } else {
      path = open_path(part(from, rows + 1, cols + 1), aggregate_);
    }
    for (Node& node : path.nodes) node = {node.i + from.i, node.j + from.j};
    return path;
  }

  /// Both paths as one; the second starts where the first one ends. Empty if one of them is.
  [[nodiscard]] Path joined(Path x, const Path& y) const {
    if (x.nodes.empty() || y.nodes.empty()) return {};
    x.invalid += y.invalid;
    x.cost = aggregate_ == Aggregate::sum ? x.cost + y.cost : std::max(x.cost, y.cost);
    if (!elastic_) {
      // The node where they meet has been counted twice.
      const std::size_t k = index(y.nodes.front());
      x.invalid -= table_.invalid[k];
      if (aggregate_ == Aggregate::sum && table_.invalid[k] == 0) x.cost -= table_.cost[k];
      x.invalid_nodes.insert(x.invalid_nodes.end(), y.invalid_nodes.begin() + 1, y.invalid_nodes.end());
    }
    x.nodes.insert(x.nodes.end(), y.nodes.begin() + 1, y.nodes.end());
    return x;
  }

  /// A closed path counts its start once.
  void close(Path& path) const {
    if (elastic_ || path.nodes.empty()) return;
    const std::size_t k = index(path.nodes.front());
    path.invalid -= table_.invalid[k];
    if (aggregate_ == Aggregate::sum && table_.invalid[k] == 0) path.cost -= table_.cost[k];
  }

 private:
  [[nodiscard]] std::size_t index(const Node& node) const {
    return table_.index(static_cast<std::size_t>(wrapped(node.i, table_.rows)),
                        static_cast<std::size_t>(wrapped(node.j, table_.cols)));
  }

  [[nodiscard]] NodeTable part(const Node& from, int rows, int cols) const {
    NodeTable t{static_cast<std::size_t>(rows), static_cast<std::size_t>(cols), {}, {}};
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < cols; ++j) {
        const std::size_t k = index({from.i + i, from.j + j});
        t.cost.push_back(table_.cost[k]);
        t.invalid.push_back(table_.invalid[k]);
      }
    }
    return t;
  }

  const Samples& a_;
  const Samples& b_;
  const MatchOptions& options_;
  bool elastic_;
  Aggregate aggregate_;
  NodeTable table_;
};

/// The pins as nodes, each after the one before it, on loops past the end if need be.
std::vector<Node> nodes_of(const Samples& a, const Samples& b, const MatchOptions& options, Layout layout,
                           bool reversed) {
  std::vector<Node> nodes;
  for (const ParameterPair& pin : options.pins) {
    nodes.push_back({node_at(a, pin.u), node_at(b, reversed ? b.domain.lo + (b.domain.hi - pin.v) : pin.v)});
  }
  std::sort(nodes.begin(), nodes.end(), [layout](const Node& x, const Node& y) {
    return layout == Layout::cut_a ? x.j < y.j : x.i < y.i;
  });
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    if (a.cyclic && nodes[k].i <= nodes[k - 1].i) nodes[k].i += static_cast<int>(a.size());
    if (b.cyclic && nodes[k].j <= nodes[k - 1].j) nodes[k].j += static_cast<int>(b.size());
  }
  return nodes;
}

Path path_through(const Stretches& curves, const Samples& a, const Samples& b, std::vector<Node> nodes,
                  Layout layout) {
  const Node laps{static_cast<int>(a.size()), static_cast<int>(b.size())};
  if (layout == Layout::toroidal) nodes.push_back({nodes.front().i + laps.i, nodes.front().j + laps.j});
  if (layout == Layout::open) {
    const Node first{0, 0};
    const Node last{laps.i - 1, laps.j - 1};
    if (!(nodes.front() == first)) nodes.insert(nodes.begin(), first);
    if (!(nodes.back() == last)) nodes.push_back(last);
  }
  Path path;
  path.nodes = {nodes.front()};
  bool first = true;
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    Path next = curves.between(nodes[k - 1], nodes[k]);
    path = first ? std::move(next) : curves.joined(std::move(path), next);
    first = false;
  }
  if (layout == Layout::toroidal) curves.close(path);
  if (layout != Layout::cut_a && layout != Layout::cut_b) return path;

  // What lies beyond the pins, cut at every node of the loop; but not where the path would have to stand
  // still on the way to a pin, since v(u) could not pass through that.
  Path best;
  const Node start = nodes.front();
  const Node end = nodes.back();
  const bool rows = layout == Layout::cut_a;
  const int least = rows ? end.i - laps.i : end.j - laps.j;
  const int most = rows ? start.i : start.j;
  for (int k = least; k <= most; ++k) {
    const Node from = rows ? Node{k, 0} : Node{0, k};
    const Node to = rows ? Node{k + laps.i, laps.j - 1} : Node{laps.i - 1, k + laps.j};
    const auto stands_still = [](const Node& x, const Node& y) { return (x.i == y.i) != (x.j == y.j); };
    if (stands_still(from, start) || stands_still(end, to)) continue;
    Path whole = curves.between(from, start);
    if (nodes.size() > 1) whole = curves.joined(std::move(whole), path);
    whole = curves.joined(std::move(whole), curves.between(end, to));
    if (clearly_better(whole, best)) best = std::move(whole);
  }
  if (best.nodes.empty()) return best;
  const int lap = rows ? (best.nodes.front().i < 0 ? laps.i : 0) : (best.nodes.front().j < 0 ? laps.j : 0);
  for (Node& node : best.nodes) (rows ? node.i : node.j) += lap;
  return best;
}

}  // namespace

SearchResult search_pinned(const Samples& a, const Samples& b, const MatchOptions& options, Layout layout) {
  SearchResult result;
  result.samples_b = b;
  const Samples backward = reversed(b);
  const std::vector<Candidate> candidates = list_candidates(a.dim(), options);
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const Samples& second = candidates[k].reversed ? backward : b;
    const Stretches curves(a, second, options, candidates[k].sign);
    Path path =
        path_through(curves, a, second, nodes_of(a, second, options, layout, candidates[k].reversed), layout);
    if (options.progress &&
        !options.progress(static_cast<double>(k + 1) / static_cast<double>(candidates.size()))) {
      result.path.cancelled = true;
      return result;
    }
    if (k > 0 && !clearly_better(path, result.path)) continue;
    result.path = std::move(path);
    result.reversed = candidates[k].reversed;
    result.samples_b = second;
  }
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
