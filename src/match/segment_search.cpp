#include "match/segment_search.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "match/segment_arcs.h"
#include "match/segment_programme.h"
#include "match/segment_runs.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Reversed must beat forward by more than rounding, relative to the cost.
constexpr double kTie = 1e-12;

int floor_div(int x, int n) {
  return x >= 0 ? x / n : -((n - 1 - x) / n);
}

/// A power of two near the largest difference of neighbouring control points: no square over- or underflows.
double scale_of(const CubicPath& a, const CubicPath& b) {
  double most = 0.0;
  for (const CubicPath* path : {&a, &b}) {
    const Points& points = path->control_points();
    for (std::size_t i = 1; i < points.size(); ++i) {
      for (std::size_t d = 0; d < points[i].size(); ++d) {
        most = std::max(most, std::fabs(0.5 * points[i][d] - 0.5 * points[i - 1][d]));
      }
    }
  }
  return most > 0.0 ? std::ldexp(1.0, std::clamp(std::ilogb(most) + 1, -1000, 1000)) : 1.0;
}

/// Compares the segments of two paths from these segments on, round once; the paths have as many.
std::partial_ordering compare(const SegmentVectors& x, std::size_t from_x, const SegmentVectors& y,
                              std::size_t from_y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto p = x.vector(from_x + i, k);
      const auto q = y.vector(from_y + i, k);
      const auto order = std::lexicographical_compare_three_way(p.begin(), p.end(), q.begin(), q.end());
      if (std::is_neq(order)) return order;
    }
  }
  return std::partial_ordering::equivalent;
}

/// The joint from which a loop's segments come first in their order.
std::size_t first_joint(const SegmentVectors& path) {
  std::size_t first = 0;
  for (std::size_t i = 1; path.closed && i < path.size(); ++i) {
    if (std::is_lt(compare(path, i, path, first))) first = i;
  }
  return first;
}

/// A path in its own order: its segments from a joint that does not depend on where it starts.
struct Ordered {
  SegmentVectors vectors;
  int first = 0;
};

Ordered in_order(const SegmentVectors& path) {
  const std::size_t first = first_joint(path);
  return {rotated(path, first), static_cast<int>(first)};
}

bool comes_before(const Ordered& x, const Ordered& y) {
  if (x.vectors.closed != y.vectors.closed) return x.vectors.closed;  // the programme's rows are the loop
  if (x.vectors.size() != y.vectors.size()) return x.vectors.size() < y.vectors.size();
  return std::is_lteq(compare(x.vectors, 0, y.vectors, 0));
}

/// Part `stage` of `stages` of the whole work.
Progress part_of(const Progress& whole, int stage, int stages) {
  if (!whole) return {};
  return [&whole, stage, stages](double fraction) { return whole((stage + fraction) / stages); };
}

/// The optimum in one direction, if there is a path and it costs less than `beat`. pins: in rows and columns.
SegmentPath run(const SegmentVectors& rows, const SegmentVectors& cols, const std::vector<Node>& pins,
                const SegmentOptions& options, double beat, int stage) {
  const std::size_t few = std::min(rows.size(), cols.size());
  const std::size_t many = std::max(rows.size(), cols.size());
  const std::size_t needed = (many + few - 1) / few;
  const std::size_t longest = options.longest_run > 0 ? static_cast<std::size_t>(options.longest_run) : many;
  if (longest < needed) {
    throw InvalidArgument("runs of up to " + std::to_string(longest) + " segments cannot match " +
                          std::to_string(few) + " segments with " + std::to_string(many) + ", expected " +
                          std::to_string(needed) + " at least");
  }
  // A path over short runs comes soon, and tells which of the long ones cannot be in the best one.
  SegmentArcs arcs(rows, cols, options.cost);
  arcs.list(std::min(longest, needed + 1), beat);
  keep_to_pins(arcs, pins);
  SegmentPath first = best_segment_path(arcs, beat, part_of(options.progress, stage, 4));
  if (first.cancelled || longest <= needed + 1) return first;
  const double most = first.nodes.empty() ? beat : first.cost;
  arcs.list(longest, most);
  keep_to_pins(arcs, pins);
  SegmentPath second = best_segment_path(arcs, most, part_of(options.progress, stage + 1, 4));
  return second.cancelled || !second.nodes.empty() ? second : first;
}

}  // namespace

FoundSegments search_segments(const CubicPath& a, const CubicPath& b, Loops loops, std::span<const Node> pins,
                              const SegmentOptions& options) {
  const int m = static_cast<int>(a.segment_count());
  const int n = static_cast<int>(b.segment_count());
  const double scale = scale_of(a, b);
  SegmentVectors vectors_a = segment_vectors(a, options.split, scale);
  SegmentVectors vectors_b = segment_vectors(b, options.split, scale);
  vectors_a.closed = loops.a;
  vectors_b.closed = loops.b;
  const Ordered own_a = in_order(vectors_a);
  const Ordered own_b = in_order(vectors_b);
  const bool swapped = !comes_before(own_a, own_b);
  const Ordered& rows = swapped ? own_b : own_a;
  const Ordered& cols = swapped ? own_a : own_b;

  // Of the second axis the joints from `first` on, backwards where it is reversed.
  const auto turned = [&](bool backward, int first) {
    std::vector<Node> nodes;
    for (const Node& pin : pins) {
      const int row = swapped ? pin.j : pin.i;
      const int col = swapped ? pin.i : pin.j;
      nodes.push_back({row - rows.first, (backward ? (swapped ? m : n) - col : col) - first});
    }
    return nodes;
  };

  FoundSegments found;
  SegmentPath best;
  int shift = 0;
  if (options.direction != Direction::reversed) {
    best = run(rows.vectors, cols.vectors, turned(false, cols.first), options,
               std::numeric_limits<double>::infinity(), 0);
    shift = cols.first;
  }
  if (options.direction != Direction::forward && !best.cancelled) {
    const double beat =
        best.nodes.empty() ? std::numeric_limits<double>::infinity() : best.cost * (1.0 - kTie);
    const Ordered backward = in_order(reversed(swapped ? vectors_a : vectors_b));
    SegmentPath path = run(rows.vectors, backward.vectors, turned(true, backward.first), options, beat, 2);
    if (path.cancelled || !path.nodes.empty()) {
      best = std::move(path);
      found.reversed = true;
      shift = backward.first;
    }
  }
  found.cancelled = best.cancelled;
  if (best.cancelled) return found;
  if (best.nodes.empty()) {
    throw InvalidArgument(
        "no path runs through all pins: they cross, or the segments between two of them are too many for the "
        "longest run");
  }
  found.cost = best.cost * scale * scale;

  for (const Node& node : best.nodes) {
    const int row = node.i + rows.first;
    const int col = node.j + shift;
    if (!swapped) {
      found.path.push_back({row, col});
    } else if (!found.reversed) {
      found.path.push_back({col, row});
    } else {
      found.path.push_back({m - col, n - row});  // col counts along the first path's reverse
    }
  }
  if (swapped && found.reversed) std::reverse(found.path.begin(), found.path.end());
  if (loops.a && loops.b) {
    found.path.pop_back();
    for (Node& node : found.path) {
      const int lap = floor_div(node.i, m);
      node = {node.i - lap * m, node.j - lap * n};
    }
    std::rotate(found.path.begin(),
                std::min_element(found.path.begin(), found.path.end(),
                                 [](const Node& x, const Node& y) { return x.i < y.i; }),
                found.path.end());
    found.path.push_back({found.path.front().i + m, found.path.front().j + n});
  }
  const Node lap{loops.a ? floor_div(found.path.front().i, m) * m : 0,
                 loops.b ? floor_div(found.path.front().j, n) * n : 0};
  for (Node& node : found.path) node = {node.i - lap.i, node.j - lap.j};
  return found;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
