#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "match/parallel_for.h"
#include "match/three_step_kernels.h"
#include "tandem/progress.h"

namespace tandem {
inline namespace v0 {
namespace detail {

template <class V>
struct BestStart {
  int start = -1;  ///< the smallest of equally good ones; -1: no path is cheaper than `unreachable`
  V cost = unreachable<V>;
  bool cancelled = false;
};

/// The best of all starts 0 .. table.rows() - 1 of a family of closed paths, exactly.
///
/// Optimal paths from different starts need not cross (two that do share a node, and may share the rest), so
/// the path from a start between two others runs between their paths (Maes 1990). Paths are found for every
/// few starts, by halves; what is left between two of them is searched for all of its starts at once, one to
/// a lane. That takes O(m^2 log m), most of it in the lanes, and holds for any costs of the three steps; not
/// for longer steps, which can cross without a common node.
template <class V>
class StartFamily {
 public:
  StartFamily(const PathFamily<V>& family, int threads)
      : family_(family), period_(family.table->rows()), threads_(worth_threads() ? threads : 1) {}

  [[nodiscard]] BestStart<V> best(const Progress& progress) {
    BestStart<V> best;
    if (progress && !progress(0.0)) {
      best.cancelled = true;
      return best;
    }
    std::vector<Gap> gaps;
    if (period_ <= lanes_) {
      gaps.push_back({0, period_, {}, {}});
    } else {
      const Path first = trace(0, {});
      offer(best, 0, first.cost);
      // One lap on it is the path from the last start's successor.
      gaps.push_back({1, period_, {0, first.spans}, {period_, first.spans}});
    }
    const auto wide = [&](const Gap& gap) { return is_wide(gap); };
    for (double done = 0.1; std::any_of(gaps.begin(), gaps.end(), wide); done += 0.1) {
      if (progress && !progress(std::min(done, 0.8))) {
        best.cancelled = true;
        return best;
      }
      gaps = halves(gaps, best);
    }
    std::vector<std::vector<V>> costs(gaps.size());
    parallel_for(static_cast<int>(gaps.size()), threads_, [&](int g) {
      const Gap& gap = gaps[static_cast<std::size_t>(g)];
      std::vector<V>& of_gap = costs[static_cast<std::size_t>(g)];
      of_gap.resize(static_cast<std::size_t>(gap.last - gap.first));
      start_costs(family_, gap.first, gap.channel(), of_gap);
    });
    for (std::size_t g = 0; g < gaps.size(); ++g) {
      for (std::size_t k = 0; k < costs[g].size(); ++k) {
        offer(best, gaps[g].first + static_cast<int>(k), costs[g][k]);
      }
    }
    return best;
  }

 private:
  struct Bound {
    int start = 0;
    std::shared_ptr<const RowSpans> spans;
  };
  /// Starts, at least one, first .. last - 1 between two paths that are known.
  struct Gap {
    int first = 0;
    int last = 0;
    Bound above;
    Bound below;

    [[nodiscard]] Channel channel() const {
      return {above.start, above.spans.get(), below.start, below.spans.get()};
    }
  };
  struct Path {
    V cost = unreachable<V>;
    std::shared_ptr<const RowSpans> spans;  ///< none if there is no path
  };

  [[nodiscard]] bool is_wide(const Gap& gap) const { return gap.last - gap.first > lanes_; }

  /// Threads cost more than they bring below some ten thousand nodes.
  [[nodiscard]] bool worth_threads() const {
    return static_cast<long long>(family_.rows) * family_.table->width() >= 1LL << 17;
  }

  [[nodiscard]] Path trace(int k, const Channel& channel) const {
    const TracedCost<V> traced = trace_path(family_, k, channel);
    Path path;
    path.cost = traced.cost;
    if (traced.nodes.empty()) return path;
    const auto rows = static_cast<std::size_t>(family_.rows);
    RowSpans spans{std::vector<int>(rows), std::vector<int>(rows)};
    for (auto n = traced.nodes.rbegin(); n != traced.nodes.rend(); ++n) {
      spans.first[static_cast<std::size_t>(n->i - k)] = n->j;
    }
    for (const Node& n : traced.nodes) spans.last[static_cast<std::size_t>(n.i - k)] = n.j;
    path.spans = std::make_shared<const RowSpans>(std::move(spans));
    return path;
  }

  static void offer(BestStart<V>& best, int start, V cost) {
    if (cost < best.cost || (cost == best.cost && best.start >= 0 && start < best.start)) {
      best.start = start;
      best.cost = cost;
    }
  }

  /// The start that halves a gap, but so that the lanes are full in the end.
  [[nodiscard]] int middle(const Gap& gap) const {
    const int batches = (gap.last - gap.first) / (lanes_ + 1) + 1;
    return gap.first + batches / 2 * (lanes_ + 1) - 1;
  }

  /// Every gap that the lanes cannot hold in two, around the path from the start in its middle. A start
  /// without a path bounds nothing.
  [[nodiscard]] std::vector<Gap> halves(const std::vector<Gap>& gaps, BestStart<V>& best) const {
    std::vector<Path> paths(gaps.size());
    parallel_for(static_cast<int>(gaps.size()), threads_, [&](int g) {
      const Gap& gap = gaps[static_cast<std::size_t>(g)];
      if (is_wide(gap)) paths[static_cast<std::size_t>(g)] = trace(middle(gap), gap.channel());
    });
    std::vector<Gap> result;
    result.reserve(2 * gaps.size());
    for (std::size_t g = 0; g < gaps.size(); ++g) {
      const Gap& gap = gaps[g];
      if (!is_wide(gap)) {
        result.push_back(gap);
        continue;
      }
      const int k = middle(gap);
      offer(best, k, paths[g].cost);
      const Bound between{k, paths[g].spans};
      const bool bounds = between.spans != nullptr;
      result.push_back({gap.first, k, gap.above, bounds ? between : gap.below});
      if (k + 1 < gap.last) result.push_back({k + 1, gap.last, bounds ? between : gap.above, gap.below});
    }
    return result;
  }

  const PathFamily<V>& family_;
  int period_;
  int lanes_ = start_lanes(V{});
  int threads_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
