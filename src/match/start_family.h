#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
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
  int start = -1;  ///< the smallest of equally good ones; -1: no path is cheaper than `kUnreachable`
  V cost = kUnreachable<V>;
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
    progress_ = &progress;
    BestStart<V> best;
    if (!report(best)) return best;
    if (period_ <= lanes_) {
      search({0, period_, {}, {}}, 0, best);
      return best;
    }
    const Path first = trace(0, {});
    offer(best, 0, first.cost);
    // One lap on it is the path from the last start's successor.
    search({1, period_, {0, first.spans}, {period_, first.spans}}, 0, best);
    return best;
  }

 private:
  struct Bound {
    int start = 0;
    std::shared_ptr<const RowSpans> spans;
  };
  /// Starts first .. last - 1 between two paths that are known.
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
    V cost = kUnreachable<V>;
    std::shared_ptr<const RowSpans> spans;  ///< none if there is no path
  };

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

  /// The best of a gap's starts: all at once if the lanes can hold them, else by halves around the path from
  /// the start in the middle. A start without a path bounds nothing.
  void search(const Gap& gap, int depth, BestStart<V>& best) {
    if (gap.first >= gap.last || best.cancelled) return;
    if (gap.last - gap.first <= lanes_) {
      std::vector<V> costs(static_cast<std::size_t>(gap.last - gap.first));
      start_costs(family_, gap.first, gap.channel(), costs);
      for (std::size_t k = 0; k < costs.size(); ++k) offer(best, gap.first + static_cast<int>(k), costs[k]);
      done_ += gap.last - gap.first;
      report(best);
      return;
    }
    const int k = middle(gap);
    const Path path = trace(k, gap.channel());
    offer(best, k, path.cost);
    const Bound between{k, path.spans};
    const bool bounds = path.spans != nullptr;
    const std::array<Gap, 2> halves = {Gap{gap.first, k, gap.above, bounds ? between : gap.below},
                                       Gap{k + 1, gap.last, bounds ? between : gap.above, gap.below}};
    // One half after the other, to the end: its costs are still in the cache.
    if (threads_ == 1 || depth >= kParallelDepth) {
      for (const Gap& half : halves) search(half, depth + 1, best);
      return;
    }
    std::array<BestStart<V>, 2> found;
    parallel_for(2, threads_, [&](int h) {
      const auto n = static_cast<std::size_t>(h);
      search(halves[n], depth + 1, found[n]);
    });
    for (const BestStart<V>& half : found) {
      if (half.start >= 0) offer(best, half.start, half.cost);
      best.cancelled |= half.cancelled;
    }
  }

  /// Tells the caller how far it is, one thread at a time; false and cancelled if that said stop.
  bool report(BestStart<V>& best) {
    if (!*progress_) return true;
    const std::lock_guard lock(mutex_);
    stopped_ = stopped_ || !(*progress_)(std::min(1.0, static_cast<double>(done_) / period_));
    best.cancelled = stopped_;
    return !stopped_;
  }

  /// Halves of halves run at once down to here: enough for eight threads.
  static constexpr int kParallelDepth = 3;

  const PathFamily<V>& family_;
  int period_;
  int lanes_ = start_lanes(V{});
  int threads_;
  const Progress* progress_ = nullptr;
  std::mutex mutex_;
  bool stopped_ = false;
  std::atomic<int> done_ = 0;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
