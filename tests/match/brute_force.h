#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "tandem/match/programme.h"

/// All paths through small tables, by recursion: what the programmes are held against.
namespace tandem::brute {

struct Found {
  std::int64_t invalid = std::numeric_limits<std::int64_t>::max();
  double cost = std::numeric_limits<double>::infinity();

  void offer(std::int64_t other_invalid, double other_cost) {
    if (other_invalid < invalid || (other_invalid == invalid && other_cost < cost)) {
      invalid = other_invalid;
      cost = other_cost;
    }
  }
};

inline double join(Aggregate aggregate, double path, double next) {
  return aggregate == Aggregate::sum ? path + next : std::max(path, next);
}

/// Every path of three steps from `at` to `end` in the unrolled table; `invalid` and `cost` are those so far.
inline void all_paths(const NodeTable& t, Aggregate aggregate, Node at, Node end, std::int64_t invalid,
                      double cost, Found& found) {
  if (at == end) {
    found.offer(invalid, cost);
    return;
  }
  for (const Node step : {Node{1, 1}, Node{0, 1}, Node{1, 0}}) {
    const Node next{at.i + step.i, at.j + step.j};
    if (next.i > end.i || next.j > end.j) continue;
    const std::size_t k =
        t.index(static_cast<std::size_t>(next.i) % t.rows, static_cast<std::size_t>(next.j) % t.cols);
    all_paths(t, aggregate, next, end, invalid + t.invalid[k], join(aggregate, cost, t.cost[k]), found);
  }
}

/// Open, with the columns shifted by `shift`.
inline Found open(const NodeTable& t, Aggregate aggregate, int shift = 0) {
  Found found;
  const std::size_t k = t.index(0, static_cast<std::size_t>(shift));
  all_paths(t, aggregate, {0, shift}, {static_cast<int>(t.rows) - 1, shift + static_cast<int>(t.cols) - 1},
            t.invalid[k], t.cost[k], found);
  return found;
}

/// The paper's form for closed curves.
inline Found pinned(const NodeTable& t, Aggregate aggregate) {
  Found best;
  for (int k = 0; k < static_cast<int>(t.cols); ++k) {
    const Found shifted = open(t, aggregate, k);
    best.offer(shifted.invalid, shifted.cost);
  }
  return best;
}

/// Toroidal.
inline Found closed(const NodeTable& t, Aggregate aggregate) {
  Found found;
  for (int k = 0; k < static_cast<int>(t.rows); ++k) {
    all_paths(t, aggregate, {k, 0}, {k + static_cast<int>(t.rows), static_cast<int>(t.cols)}, 0, 0.0, found);
  }
  return found;
}

/// The rows' loop cut anywhere.
inline Found cut(const NodeTable& t, Aggregate aggregate) {
  Found found;
  for (int k = 0; k < static_cast<int>(t.rows); ++k) {
    const std::size_t start = t.index(static_cast<std::size_t>(k), 0);
    all_paths(t, aggregate, {k, 0}, {k + static_cast<int>(t.rows), static_cast<int>(t.cols) - 1},
              t.invalid[start], t.cost[start], found);
  }
  return found;
}

inline void all_paths(const EdgeTable& t, Aggregate aggregate, Node at, Node end, std::int64_t invalid,
                      double cost, Found& found) {
  if (at == end) {
    found.offer(invalid, cost);
    return;
  }
  for (std::size_t s = 0; s < t.steps.size(); ++s) {
    const Node next{at.i + t.steps[s].a, at.j + t.steps[s].b};
    if (next.i > end.i || next.j > end.j) continue;
    const std::size_t k =
        t.index(static_cast<std::size_t>(next.i) % t.rows, s, static_cast<std::size_t>(next.j) % t.cols);
    if (t.cost[k] == std::numeric_limits<double>::infinity()) continue;
    all_paths(t, aggregate, next, end, invalid + static_cast<std::int64_t>(t.invalid[k]),
              join(aggregate, cost, t.cost[k]), found);
  }
}

inline Found open(const EdgeTable& t, Aggregate aggregate) {
  Found found;
  all_paths(t, aggregate, {0, 0}, {static_cast<int>(t.rows) - 1, static_cast<int>(t.cols) - 1}, 0, 0.0,
            found);
  return found;
}

/// The starts are all nodes, whatever the programme believes to be enough.
inline Found closed(const EdgeTable& t, Aggregate aggregate) {
  Found found;
  for (int k = 0; k < static_cast<int>(t.rows); ++k) {
    for (int l = 0; l < static_cast<int>(t.cols); ++l) {
      all_paths(t, aggregate, {k, l}, {k + static_cast<int>(t.rows), l + static_cast<int>(t.cols)}, 0, 0.0,
                found);
    }
  }
  return found;
}

inline Found cut(const EdgeTable& t, Aggregate aggregate) {
  Found found;
  for (int k = 0; k < static_cast<int>(t.rows); ++k) {
    all_paths(t, aggregate, {k, 0}, {k + static_cast<int>(t.rows), static_cast<int>(t.cols) - 1}, 0, 0.0,
              found);
  }
  return found;
}

}  // namespace tandem::brute
