#include "tandem/rank/rank.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <utility>

#include "rank/stream.h"

namespace tandem {
inline namespace v0 {

namespace {

bool better(const RankedShape& x, const RankedShape& y) {
  return x.comparison.cost < y.comparison.cost ||
         (x.comparison.cost == y.comparison.cost && x.index < y.index);
}

/// The best so far, from several threads.
class TopList {
 public:
  explicit TopList(const RankOptions& options) : options_(options) {}

  /// No candidate above this cost comes among the best. It only falls, so what is pruned by an older value
  /// stays pruned, whatever the order in which threads finish.
  [[nodiscard]] double limit() const { return limit_.load(std::memory_order_relaxed); }

  void add(RankedShape shape) {
    const std::lock_guard lock(mutex_);
    if (options_.top == 0) {
      shapes_.push_back(std::move(shape));
      return;
    }
    if (shapes_.size() == options_.top && !better(shape, shapes_.front())) return;
    // A heap with the worst of the best in front.
    shapes_.push_back(std::move(shape));
    std::push_heap(shapes_.begin(), shapes_.end(), better);
    if (shapes_.size() > options_.top) {
      std::pop_heap(shapes_.begin(), shapes_.end(), better);
      shapes_.pop_back();
    }
    if (options_.prune && shapes_.size() == options_.top) limit_ = shapes_.front().comparison.cost;
  }

  [[nodiscard]] std::vector<RankedShape> sorted() && {
    std::sort(shapes_.begin(), shapes_.end(), better);
    return std::move(shapes_);
  }

 private:
  const RankOptions& options_;
  std::atomic<double> limit_ = std::numeric_limits<double>::infinity();
  std::mutex mutex_;
  std::vector<RankedShape> shapes_;
};

}  // namespace

Ranking rank(const ShapeDescriptor& query, const CandidateSource& source, const RankOptions& options) {
  const ShapeComparer comparer(query, options.compare);
  TopList list(options);
  std::atomic<std::size_t> pruned = 0;
  Ranking ranking;
  const auto work = [&](const detail::Described& each, std::size_t index) {
    if (!comparer.is_comparable(*each.shape)) return;
    const double limit = list.limit();
    if (limit < std::numeric_limits<double>::infinity() && comparer.lower_bound(*each.shape) > limit) {
      ++pruned;
      return;
    }
    std::optional<Comparison> comparison = comparer.compare(*each.shape, limit);
    if (comparison) {
      const std::string& name = each.shape->name();
      list.add({name.empty() ? each.candidate.name : name, each.shape->label(), index, *std::move(comparison),
                options.keep_shapes ? each.shape : std::nullopt});
    }
  };
  const auto collect = [&](const detail::Described& each, std::size_t) {
    ++ranking.candidates;
    if (each.error) ++ranking.failed;
    if (each.shape && !comparer.is_comparable(*each.shape)) ++ranking.incomparable;
  };
  ranking.cancelled = !detail::for_each_described(source, options.stream, work, collect);
  ranking.best = std::move(list).sorted();
  ranking.pruned = pruned;
  return ranking;
}

Ranking rank(const ShapeDescriptor& query, std::span<const ShapeDescriptor> candidates,
             const RankOptions& options) {
  std::size_t next = 0;
  RankOptions own = options;
  own.stream.fraction = [&] { return static_cast<double>(next) / static_cast<double>(candidates.size()); };
  const CandidateSource source = [&]() -> std::optional<Candidate> {
    if (next == candidates.size()) return std::nullopt;
    const ShapeDescriptor& shape = candidates[next++];
    return Candidate{shape.name(), [&shape] { return shape; }, true};
  };
  return rank(query, source, own);
}

bool describe_all(const CandidateSource& source, const std::function<void(ShapeDescriptor)>& sink,
                  const StreamOptions& options) {
  return detail::for_each_described(
      source, options, [](const detail::Described&, std::size_t) {},
      [&](detail::Described& each, std::size_t) {
        if (each.shape) sink(*std::move(each.shape));
      });
}

}  // namespace v0
}  // namespace tandem
