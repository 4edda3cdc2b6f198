#include "match/search.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "match/candidates.h"
#include "match/elastic_programme.h"
#include "match/lexicographic.h"
#include "match/parallel_for.h"
#include "match/search_pinned.h"
#include "tandem/error.h"
#include "tandem/match/elastic.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Below this size of a table (pairs of nodes) threads cost more than they bring.
constexpr std::size_t kWorthThreads = 4096;

Path swapped(Path path) {
  for (Node& node : path.nodes) std::swap(node.i, node.j);
  return path;
}

Path elastic_path(const Samples& a, const Samples& b, const MatchOptions& options, Layout layout,
                  RuledSign sign, const Band* band, EdgePlans* plans, const Progress& progress,
                  const Path* beat) {
  if (is_transposed(layout, Method::elastic)) {
    return swapped(elastic_path(b, a, options, Layout::cut_a,
                                sign == RuledSign::positive   ? RuledSign::negative
                                : sign == RuledSign::negative ? RuledSign::positive
                                                              : sign,
                                band, plans, progress, beat));
  }
  // Large tables take as long as a programme that asks on its way.
  const auto stop = [&] { return progress && !progress(0.0); };
  Path stopped;
  stopped.cancelled = true;
  if (stop()) return stopped;
  const Aggregate aggregate = aggregate_of(options.norm);
  const NodeTable chords = chord_costs(a, b, options.norm, options.features, sign);
  if (stop()) return stopped;
  EdgeRows edges(a, b, chords, options.elastic, aggregate,
                 plans == nullptr ? nullptr : plans->find(a, b, options.elastic.longest_step));
  return best_elastic_path(edges, aggregate, band, progress, beat);
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

/// The table with every node beside the band barred.
NodeTable bar_beside(NodeTable nodes, const Band& band) {
  const int rows = static_cast<int>(nodes.rows);
  const int cols = static_cast<int>(nodes.cols);
  std::vector<double> cost(nodes.cost.size(), std::numeric_limits<double>::infinity());
  for (std::size_t r = 0; r < band.columns.size(); ++r) {
    const int i = ((band.first_row + static_cast<int>(r)) % rows + rows) % rows;
    for (int j = band.columns[r].lo; j <= band.columns[r].hi; ++j) {
      const std::size_t k =
          nodes.index(static_cast<std::size_t>(i), static_cast<std::size_t>((j % cols + cols) % cols));
      cost[k] = nodes.cost[k];
    }
  }
  nodes.cost = std::move(cost);
  return nodes;
}

Path paper_path(const Samples& a, const Samples& b, const MatchOptions& options, Layout layout,
                RuledSign sign, const Band* band, EdgePlans* /*plans*/, const Progress& progress,
                const Path* /*beat*/) {
  const Aggregate aggregate = aggregate_of(options.norm);
  NodeTable nodes = node_costs(a, b, options.norm, options.features, sign);
  if (layout == Layout::cut_b) nodes = transposed(nodes);
  if (band != nullptr) nodes = bar_beside(std::move(nodes), *band);
  switch (layout) {
    case Layout::toroidal:
      return closed_path(nodes, aggregate, progress, options.threads);
    case Layout::pinned:
      return pinned_path(nodes, aggregate, progress, options.threads);
    case Layout::cut_a:
      return cut_path(nodes, aggregate, progress, options.threads);
    case Layout::cut_b:
      return swapped(cut_path(nodes, aggregate, progress, options.threads));
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

/// Twice the area that the polygon of chords encloses, in units of the squared length; 0 outside the plane.
double signed_area(const Samples& s) {
  if (s.dim() != 2) return 0.0;
  double area = 0.0;
  double x = 0.0;
  double y = 0.0;
  for (std::size_t k = 0; k < s.chords(); ++k) {
    const double dx = s.chord_tangents[k][0] * s.chord_lengths[k];
    const double dy = s.chord_tangents[k][1] * s.chord_lengths[k];
    area += x * dy - y * dx;
    x += dx;
    y += dy;
  }
  return area;
}

/// Runs every candidate. Where starts are searched, the likelier direction goes first, and the others only
/// have to find out that they cannot beat it, which mostly takes a single bound.
class CandidateRuns {
 public:
  CandidateRuns(const Samples& a, const Samples& b, const MatchOptions& options, Layout layout,
                const Band* band, EdgePlans* plans)
      : a_(a),
        b_(b),
        options_(options),
        layout_(layout),
        band_(band),
        plans_(plans),
        candidates_(list_candidates(a.dim(), options)),
        paths_(candidates_.size()),
        progress_(options.progress, static_cast<int>(candidates_.size())) {
    for (const Candidate& c : candidates_) {
      if (c.reversed && !backward_) backward_ = reversed(b);
    }
  }

  void run() {
    std::vector<std::size_t> rest(candidates_.size());
    std::iota(rest.begin(), rest.end(), std::size_t{0});
    const Path* beat = nullptr;
    // The three-step programmes take the same time whatever is to be beaten: they run at once.
    if (layout_ != Layout::open && options_.method == Method::elastic) {
      const bool opposed = signed_area(a_) * signed_area(b_) < 0.0;
      const auto likely = std::find_if(rest.begin(), rest.end(),
                                       [&](std::size_t k) { return candidates_[k].reversed == opposed; });
      const std::size_t first = likely == rest.end() ? 0 : *likely;
      run_one(first, nullptr);
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(first));
      beat = &paths_[first];
      if (beat->cancelled) return;
    }
    const int threads = a_.size() * b_.size() < kWorthThreads ? 1 : options_.threads;
    parallel_for(static_cast<int>(rest.size()), threads,
                 [&](int k) { run_one(rest[static_cast<std::size_t>(k)], beat); });
  }

  /// The best candidate: the earlier one in the list on a tie. Cancelled if one of them was.
  [[nodiscard]] SearchResult best() && {
    std::size_t best = 0;
    SearchResult result;
    for (std::size_t k = 0; k < paths_.size(); ++k) {
      if (paths_[k].cancelled) {
        result.path.cancelled = true;
        result.samples_b = b_;
        return result;
      }
      if (k > 0 && clearly_better(paths_[k], paths_[best])) best = k;
    }
    result.path = std::move(paths_[best]);
    result.reversed = candidates_[best].reversed;
    result.samples_b = result.reversed ? *std::move(backward_) : b_;
    return result;
  }

 private:
  void run_one(std::size_t k, const Path* beat) {
    const Candidate& c = candidates_[k];
    const Progress own = progress_.for_candidate();
    const auto programme = options_.method == Method::paper ? paper_path : elastic_path;
    paths_[k] =
        programme(a_, c.reversed ? *backward_ : b_, options_, layout_, c.sign, band_, plans_, own, beat);
    // An open programme is too short to ask on its way; the answer counts all the same.
    if (own && !own(1.0)) paths_[k].cancelled = true;
  }

  const Samples& a_;
  const Samples& b_;
  const MatchOptions& options_;
  Layout layout_;
  const Band* band_;
  EdgePlans* plans_;
  std::vector<Candidate> candidates_;
  std::optional<Samples> backward_;
  std::vector<Path> paths_;
  SharedProgress progress_;
};

}  // namespace

SearchResult search(const Samples& a, const Samples& b, const MatchOptions& options, Layout layout,
                    const Band* band, EdgePlans* plans) {
  if (!options.pins.empty()) return search_pinned(a, b, options, layout);
  CandidateRuns runs(a, b, options, layout, band, plans);
  runs.run();
  SearchResult result = std::move(runs).best();
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
