#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "tandem/curve/arc_length.h"
#include "tandem/match/segments.h"

/// [D]'s method by its definition, with nothing of the library's but curves and lengths.
namespace tandem::plain {

using Cubic = std::array<Point, 4>;

inline Cubic segment(const CubicPath& path, int i) {
  const int n = static_cast<int>(path.segment_count());
  const auto p = path.segment(static_cast<std::size_t>(i % n));
  Cubic cubic;
  for (std::size_t k = 0; k < 4; ++k) cubic[k] = Point(p[k].begin(), p[k].end());
  return cubic;
}

inline Point mix(const Point& x, const Point& y, double t) {
  Point z(x.size());
  for (std::size_t d = 0; d < x.size(); ++d) z[d] = (1.0 - t) * x[d] + t * y[d];
  return z;
}

/// De Casteljau: the parts before and after t.
inline std::pair<Cubic, Cubic> halves(const Cubic& p, double t) {
  const Point a = mix(p[0], p[1], t);
  const Point b = mix(p[1], p[2], t);
  const Point c = mix(p[2], p[3], t);
  const Point d = mix(a, b, t);
  const Point e = mix(b, c, t);
  const Point f = mix(d, e, t);
  return {{p[0], a, d, f}, {f, e, c, p[3]}};
}

inline double length(const Cubic& p) {
  Points points;
  for (const Point& x : p) points.push_back(x);
  return arc_length(Curve(3, {0, 0, 0, 0, 1, 1, 1, 1}, std::move(points)));
}

inline double paper_cost(const Cubic& p, const Cubic& q) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t d = 0; d < p[0].size(); ++d) {
      const double gap = (q[k][d] - p[k][d]) - (q[k + 1][d] - p[k + 1][d]);
      sum += gap * gap;
    }
  }
  return sum;
}

inline double slope(const Cubic& p, double t, std::size_t d) {
  const double u = 1.0 - t;
  return 3.0 *
         (u * u * (p[1][d] - p[0][d]) + 2.0 * u * t * (p[2][d] - p[1][d]) + t * t * (p[3][d] - p[2][d]));
}

/// The integral of |p' - q'|^2, both run through in time h: Gauss-Legendre, exact for degree 5.
inline double derivative_cost(const Cubic& p, const Cubic& q, double h) {
  if (h == 0.0) return 0.0;
  const double x = std::sqrt(0.6);
  double sum = 0.0;
  for (const auto& [node, weight] :
       {std::pair(-x, 5.0 / 9.0), std::pair(0.0, 8.0 / 9.0), std::pair(x, 5.0 / 9.0)}) {
    const double t = 0.5 + 0.5 * node;
    for (std::size_t d = 0; d < p[0].size(); ++d) {
      const double gap = (slope(p, t, d) - slope(q, t, d)) / h;
      sum += 0.5 * weight * gap * gap * h;
    }
  }
  return sum;
}

/// Segment i of `one` against `count` segments of `run`.
inline double arc_cost(const CubicPath& one, int i, const CubicPath& run, int first, int count,
                       const SegmentOptions& options) {
  std::vector<double> shares;
  double whole = 0.0;
  for (int l = 0; l < count; ++l) {
    shares.push_back(options.split == SegmentSplit::uniform ? 1.0 : length(segment(run, first + l)));
    whole += shares.back();
  }
  Cubic rest = segment(one, i);
  double left = 1.0;
  double sum = 0.0;
  for (int l = 0; l < count; ++l) {
    const double h = shares[static_cast<std::size_t>(l)] / whole;
    const auto [piece, after] = halves(rest, l + 1 == count ? 1.0 : h / left);
    const Cubic other = segment(run, first + l);
    sum += options.cost == SegmentCost::paper ? paper_cost(piece, other) : derivative_cost(piece, other, h);
    rest = after;
    left -= h;
  }
  return sum;
}

inline double node_to_node(const CubicPath& a, const CubicPath& b, Node from, Node to,
                           const SegmentOptions& options) {
  return to.i - from.i == 1 ? arc_cost(a, from.i, b, from.j, to.j - from.j, options)
                            : arc_cost(b, from.j, a, from.i, to.i - from.i, options);
}

/// Every monotone path of arcs.
inline double best(const CubicPath& a, const CubicPath& b, Node at, Node end, const SegmentOptions& options) {
  if (at == end) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](Node next) {
    if (next.i > end.i || next.j > end.j) return;
    if (options.longest_run > 0 && std::max(next.i - at.i, next.j - at.j) > options.longest_run) return;
    const double rest = best(a, b, next, end, options);
    if (rest < least) least = std::min(least, node_to_node(a, b, at, next, options) + rest);
  };
  for (int k = 1; at.j + k <= end.j; ++k) offer({at.i + 1, at.j + k});
  for (int k = 2; at.i + k <= end.i; ++k) offer({at.i + k, at.j + 1});
  return least;
}

/// Over all starts where the paths are closed, in one direction.
inline double best(const CubicPath& a, const CubicPath& b, const SegmentOptions& options) {
  const int m = static_cast<int>(a.segment_count());
  const int n = static_cast<int>(b.segment_count());
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < (a.is_closed() ? m : 1); ++i) {
    for (int j = 0; j < (b.is_closed() ? n : 1); ++j) {
      least = std::min(least, best(a, b, {i, j}, {i + m, j + n}, options));
    }
  }
  return least;
}

}  // namespace tandem::plain
