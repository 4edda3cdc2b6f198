#pragma once

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

#include "match/lexicographic.h"
#include "tandem/progress.h"

namespace tandem {
inline namespace v0 {

/// What a programme that starts at many nodes at once found at the end that belongs to one of them.
struct StartBound {
  LexCost cost = LexCost::infinite();  ///< no path from this start to its own end is cheaper
  int origin = -1;                     ///< the start from which the path at this end really comes
};

struct StartChoice {
  int start = -1;
  LexCost cost = LexCost::infinite();
  bool cancelled = false;
};

/// Costs this close are one when a search is bounded by another search's result: the caller decides on ties,
/// so they must be found.
inline constexpr double kTieMargin = 1e-9;

/// The best of `count` starts of a closed path, exact, by branch and bound.
///
/// bound(first, last) runs the programme with all starts of [first, last) at once and returns one StartBound
/// each. Where origin is the start itself, the bound is the cost of a true closed path; the other starts are
/// searched again in halves, best bound first, until none can beat the best path found. Rounding does no
/// harm: addition and minimum are monotone in floating point, so a bound is never above the cost that it
/// bounds.
///
/// limit: the search gives up (start < 0) when it is certain that no start beats this cost.
template <class BoundFunction>
class StartSearch {
 public:
  StartSearch(int count, const BoundFunction& bound, LexCost limit) : bound_(bound), limit_(limit) {
    limit_.cost += kTieMargin * limit_.cost;
    open_.push({0, count, {0.0, 0.0}});
  }

  [[nodiscard]] StartChoice run(const Progress& progress) {
    for (int rounds = 1; !open_.empty(); ++rounds) {
      const Range range = open_.top();
      open_.pop();
      if (!promising(range.lower)) break;
      examine(range);
      if (progress && !progress(rounds / (rounds + static_cast<double>(open_.size())))) {
        best_.cancelled = true;
        return best_;
      }
    }
    return best_;
  }

 private:
  struct Range {
    int first;
    int last;
    LexCost lower;
  };
  struct Worse {
    bool operator()(const Range& x, const Range& y) const {
      return y.lower < x.lower || (y.lower == x.lower && y.first < x.first);
    }
  };

  [[nodiscard]] bool promising(LexCost lower) const {
    return best_.start >= 0 ? lower < best_.cost : !(limit_ < lower);
  }

  void offer(int start, const StartBound& b) {
    if (b.origin == start && promising(b.cost)) best_ = {start, b.cost, false};
  }

  void examine(const Range& range) {
    const std::vector<StartBound> bounds = bound_(range.first, range.last);
    const auto bound_of = [&](int k) { return bounds[static_cast<std::size_t>(k - range.first)]; };
    for (int k = range.first; k < range.last; ++k) offer(k, bound_of(k));
    const auto undecided = [&](int k) {
      const StartBound b = bound_of(k);
      return b.origin >= 0 && b.origin != k && promising(b.cost);
    };
    // A true path early cuts off most of the search: try the start that promises most.
    int likely = -1;
    for (int k = range.first; k < range.last; ++k) {
      if (undecided(k) && (likely < 0 || bound_of(k).cost < bound_of(likely).cost)) likely = k;
    }
    if (likely < 0) return;
    offer(likely, bound_(likely, likely + 1).front());

    int first = range.first;
    int last = range.last;
    while (first < last && (first == likely || !undecided(first))) ++first;
    while (last > first && (last - 1 == likely || !undecided(last - 1))) --last;
    const int middle = first + (last - first + 1) / 2;
    for (const auto& [lo, hi] : {std::pair{first, middle}, std::pair{middle, last}}) {
      LexCost lower = LexCost::infinite();
      for (int k = lo; k < hi; ++k) {
        if (k != likely && undecided(k)) lower = std::min(lower, bound_of(k).cost);
      }
      if (lower < LexCost::infinite()) open_.push({lo, hi, lower});
    }
  }

  const BoundFunction& bound_;
  LexCost limit_;
  StartChoice best_;
  std::priority_queue<Range, std::vector<Range>, Worse> open_;
};

template <class BoundFunction>
[[nodiscard]] StartChoice search_starts(int count, const BoundFunction& bound, const Progress& progress,
                                        LexCost limit = LexCost::infinite()) {
  return StartSearch<BoundFunction>(count, bound, limit).run(progress);
}

}  // namespace v0
}  // namespace tandem
