#include "match/search.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "match/lexicographic.h"
#include "match/parallel_for.h"
#include "tandem/error.h"
#include "tandem/match/elastic.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Below this size of a table (pairs of nodes) threads cost more than they bring.
constexpr std::size_t kWorthThreads = 4096;

/// Reversed must beat forward by more than rounding, relative to the cost.
constexpr double kTie = 1e-12;

struct Candidate {
  bool reversed = false;
  RuledSign sign = RuledSign::product;
};

std::vector<Candidate> list_candidates(const Samples& a, const MatchOptions& options) {
  std::vector<RuledSign> signs = {RuledSign::product};
  const auto* kind = std::get_if<NormKind>(&options.norm);
  if (kind != nullptr && *kind == NormKind::ruled && a.dim() == 2 && options.method != Method::paper) {
    signs = {RuledSign::positive, RuledSign::negative};
  }
  std::vector<Candidate> candidates;
  for (const bool reversed : {false, true}) {
    if (options.direction == (reversed ? Direction::forward : Direction::reversed)) continue;
    for (const RuledSign sign : signs) candidates.push_back({reversed, sign});
  }
  return candidates;
}

Aggregate aggregate_of(const Norm& norm) {
  const auto* kind = std::get_if<NormKind>(&norm);
  return kind != nullptr && *kind == NormKind::bottleneck ? Aggregate::maximum : Aggregate::sum;
}

Path swapped(Path path) {
  for (Node& node : path.nodes) std::swap(node.i, node.j);
  return path;
}

NodeMask transposed(const NodeMask& mask) {
  NodeMask t{mask.cols, mask.rows, std::vector<std::uint8_t>(mask.allowed.size())};
  for (std::size_t k = 0; k < mask.allowed.size(); ++k)
    t.allowed[k % mask.cols * mask.rows + k / mask.cols] = mask.allowed[k];
  return t;
}

/// The mask for the samples of b in reverse order.
NodeMask reversed(const NodeMask& mask, const Samples& b) {
  NodeMask r = mask;
  const bool keep_first = b.cyclic && b.parameters.front() == b.domain.lo;
  for (std::size_t i = 0; i < mask.rows && !mask.allowed.empty(); ++i) {
    for (std::size_t j = 0; j < mask.cols; ++j) {
      const std::size_t k = keep_first ? (mask.cols - j) % mask.cols : mask.cols - 1 - j;
      r.allowed[i * mask.cols + j] = mask.allowed[i * mask.cols + k];
    }
  }
  return r;
}

Path elastic_path(const Samples& a, const Samples& b, const MatchOptions& options, Layout layout,
                  RuledSign sign, const NodeMask& mask, const Progress& progress) {
  if (layout == Layout::cut_b || layout == Layout::pinned) {
    return swapped(elastic_path(b, a, options, Layout::cut_a,
                                sign == RuledSign::positive   ? RuledSign::negative
                                : sign == RuledSign::negative ? RuledSign::positive
                                                              : sign,
                                transposed(mask), progress));
  }
  const Aggregate aggregate = aggregate_of(options.norm);
  const NodeTable chords = chord_costs(a, b, options.norm, options.features, sign);
  const EdgeTable edges = edge_costs(a, b, chords, options.elastic, aggregate, mask);
  if (layout == Layout::toroidal) return closed_path(edges, aggregate, progress);
  if (layout == Layout::cut_a) return cut_path(edges, aggregate, progress);
  return open_path(edges, aggregate);
}

NodeTable transposed(const NodeTable& table) {
  NodeTable t{table.cols, table.rows, std::vector<double>(table.cost.size()),
              std::vector<std::uint8_t>(table.invalid.size())};
  for (std::size_t k = 0; k < table.cost.size(); ++k) {
    const std::size_t to = k % table.cols * table.rows + k / table.cols;
    t.cost[to] = table.cost[k];
    t.invalid[to] = table.invalid[k];
  }
  return t;
}

Path paper_path(const Samples& a, const Samples& b, const MatchOptions& options, Layout layout,
                RuledSign sign, const NodeMask& mask, const Progress& progress) {
  const Aggregate aggregate = aggregate_of(options.norm);
  NodeTable nodes = node_costs(a, b, options.norm, options.features, sign);
  for (std::size_t k = 0; k < mask.allowed.size(); ++k) {
    if (mask.allowed[k] == 0) nodes.cost[k] = std::numeric_limits<double>::infinity();
  }
  switch (layout) {
    case Layout::toroidal:
      return closed_path(nodes, aggregate, progress);
    case Layout::pinned:
      return pinned_path(nodes, aggregate, progress);
    case Layout::cut_a:
      return cut_path(nodes, aggregate, progress);
    case Layout::cut_b:
      return swapped(cut_path(transposed(nodes), aggregate, progress));
    case Layout::open:
      break;
  }
  return open_path(nodes, aggregate);
}

/// Turns a closed path so that it starts at the smallest i >= 0, with j in [0, m2).
Path in_own_order(Path path, int m1, int m2) {
  std::vector<Node>& nodes = path.nodes;
  nodes.pop_back();  // the start again, one lap on
  const auto wraps = std::find_if(nodes.begin(), nodes.end(), [&](const Node& n) { return n.i >= m1; });
  for (auto n = wraps; n != nodes.end(); ++n) *n = {n->i - m1, n->j - m2};
  const auto turn = wraps - nodes.begin();
  std::rotate(nodes.begin(), wraps, nodes.end());
  const int first = nodes.front().j;
  const int lap = (first >= 0 ? first / m2 : -((m2 - 1 - first) / m2)) * m2;
  for (Node& n : nodes) n.j -= lap;
  nodes.push_back({nodes.front().i + m1, nodes.front().j + m2});
  if (!path.invalid_nodes.empty()) {
    path.invalid_nodes.pop_back();
    std::rotate(path.invalid_nodes.begin(), path.invalid_nodes.begin() + turn, path.invalid_nodes.end());
    path.invalid_nodes.push_back(path.invalid_nodes.front());
  }
  return path;
}

/// A progress callback for each of several candidates that run at once; the caller's sees one rising
/// fraction.
class SharedProgress {
 public:
  SharedProgress(const Progress& progress, int count) : progress_(progress), count_(count) {}

  [[nodiscard]] Progress for_candidate() {
    if (!progress_) return {};
    return [this, last = 0.0](double fraction) mutable {
      const std::lock_guard lock(mutex_);
      if (cancelled_) return false;
      total_ += std::max(0.0, fraction - last) / count_;
      last = std::max(last, fraction);
      cancelled_ = !progress_(std::min(total_, 1.0));
      return !cancelled_;
    };
  }

 private:
  const Progress& progress_;
  int count_;
  std::mutex mutex_;
  double total_ = 0.0;
  bool cancelled_ = false;
};

bool clearly_better(const Path& x, const Path& y) {
  if (y.nodes.empty()) return !x.nodes.empty();
  if (x.nodes.empty() || x.invalid != y.invalid) return !x.nodes.empty() && x.invalid < y.invalid;
  return x.cost < y.cost - kTie * y.cost;
}

}  // namespace

SearchResult search(const Samples& a, const Samples& b, const MatchOptions& options, Layout layout,
                    const NodeMask& mask) {
  const std::vector<Candidate> candidates = list_candidates(a, options);
  std::optional<Samples> backward;
  for (const Candidate& c : candidates) {
    if (c.reversed && !backward) backward = reversed(b);
  }
  const auto run = options.method == Method::paper ? paper_path : elastic_path;
  SharedProgress progress(options.progress, static_cast<int>(candidates.size()));
  std::vector<Path> paths(candidates.size());
  const int threads = a.size() * b.size() < kWorthThreads ? 1 : options.threads;
  parallel_for(static_cast<int>(candidates.size()), threads, [&](int k) {
    const Candidate& c = candidates[static_cast<std::size_t>(k)];
    const Progress own = progress.for_candidate();
    paths[static_cast<std::size_t>(k)] = run(a, c.reversed ? *backward : b, options, layout, c.sign,
                                             c.reversed ? reversed(mask, b) : mask, own);
    // An open programme is too short to ask on its way; the answer counts all the same.
    if (own && !own(1.0)) paths[static_cast<std::size_t>(k)].cancelled = true;
  });

  std::size_t best = 0;
  SearchResult result;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    if (paths[k].cancelled) {
      result.path.cancelled = true;
      result.samples_b = b;
      return result;
    }
    if (k > 0 && clearly_better(paths[k], paths[best])) best = k;
  }
  result.path = std::move(paths[best]);
  result.reversed = candidates[best].reversed;
  result.samples_b = result.reversed ? *std::move(backward) : b;
  if (result.path.nodes.empty()) return result;
  const int m1 = static_cast<int>(a.size());
  const int m2 = static_cast<int>(b.size());
  if (layout == Layout::pinned && options.method == Method::paper) {
    result.path.nodes.push_back({result.path.nodes.front().i + m1, result.path.nodes.front().j + m2});
    result.path.invalid_nodes.push_back(result.path.invalid_nodes.front());
  }
  if (layout == Layout::toroidal) result.path = in_own_order(std::move(result.path), m1, m2);
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
