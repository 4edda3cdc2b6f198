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

/// The best of `count` starts of a closed path, exact, by branch and bound.
///
/// bound(first, last) runs the programme with all starts of [first, last) at once and returns one StartBound
/// each. Where origin is the start itself, the bound is the cost of a true closed path; the other starts are
/// searched again in halves, best bound first, until none can beat the best path found. Rounding does no
/// harm: addition and minimum are monotone in floating point, so a bound is never above the cost that it
/// bounds.
template <class BoundFunction>
[[nodiscard]] StartChoice search_starts(int count, const BoundFunction& bound, const Progress& progress) {
  struct Range {
    int first;
    int last;
    LexCost lower;
  };
  const auto worse = [](const Range& x, const Range& y) {
    return y.lower < x.lower || (y.lower == x.lower && y.first < x.first);
  };
  std::priority_queue<Range, std::vector<Range>, decltype(worse)> open(worse);
  open.push({0, count, {0.0, 0.0}});
  StartChoice best;
  for (int rounds = 1; !open.empty(); ++rounds) {
    const Range range = open.top();
    open.pop();
    if (best.start >= 0 && !(range.lower < best.cost)) break;
    const std::vector<StartBound> bounds = bound(range.first, range.last);
    const auto bound_of = [&](int k) { return bounds[static_cast<std::size_t>(k - range.first)]; };
    for (int k = range.first; k < range.last; ++k) {
      const StartBound b = bound_of(k);
      if (b.origin == k && (best.start < 0 || b.cost < best.cost)) best = {k, b.cost, false};
    }
    const auto undecided = [&](int k) {
      const StartBound b = bound_of(k);
      return b.origin >= 0 && b.origin != k && (best.start < 0 || b.cost < best.cost);
    };
    int first = range.first;
    int last = range.last;
    while (first < last && !undecided(first)) ++first;
    while (last > first && !undecided(last - 1)) --last;
    const int middle = first + (last - first + 1) / 2;
    for (const auto& [lo, hi] : {std::pair{first, middle}, std::pair{middle, last}}) {
      LexCost lower = LexCost::infinite();
      for (int k = lo; k < hi; ++k) {
        if (undecided(k)) lower = std::min(lower, bound_of(k).cost);
      }
      if (lower < LexCost::infinite()) open.push({lo, hi, lower});
    }
    if (progress && !progress(rounds / (rounds + static_cast<double>(open.size())))) {
      best.cancelled = true;
      return best;
    }
  }
  return best;
}

}  // namespace v0
}  // namespace tandem
