#include "tandem/match/segments.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "match/segment_runs.h"
#include "match/segment_search.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

namespace {

using detail::FoundSegments;
using detail::Loops;
using detail::SegmentVectors;

std::size_t wrap(int i, std::size_t n) {
  const int size = static_cast<int>(n);
  return static_cast<std::size_t>((i % size + size) % size);
}

/// Both paths cut into pieces that belong together.
struct Pieces {
  std::vector<SegmentPiece> a;
  std::vector<SegmentPiece> b;  ///< of the second path as run through
  std::size_t first = 0;        ///< the piece that begins at the first path's start joint
};

void add_single(std::vector<SegmentPiece>& pieces, std::size_t segment, const std::vector<double>& at) {
  for (std::size_t l = 0; l + 1 < at.size(); ++l) pieces.push_back({segment, at[l], at[l + 1]});
}

void add_run(std::vector<SegmentPiece>& pieces, int first, int count, std::size_t n) {
  for (int l = 0; l < count; ++l) pieces.push_back({wrap(first + l, n), 0.0, 1.0});
}

Pieces cut(const std::vector<Node>& path, const SegmentVectors& a, const SegmentVectors& b) {
  Pieces pieces;
  for (std::size_t k = 1; k < path.size(); ++k) {
    const Node from = path[k - 1];
    const int rows = path[k].i - from.i;
    const int cols = path[k].j - from.j;
    for (int l = 0; l < rows; ++l) {
      if (wrap(from.i + l, a.size()) == 0) pieces.first = pieces.a.size() + static_cast<std::size_t>(l);
    }
    const std::size_t i = wrap(from.i, a.size());
    const std::size_t j = wrap(from.j, b.size());
    if (rows == 1) {
      add_single(pieces.a, i, detail::split_parameters(b, j, static_cast<std::size_t>(cols)));
      add_run(pieces.b, from.j, cols, b.size());
    } else {
      add_run(pieces.a, from.i, rows, a.size());
      add_single(pieces.b, j, detail::split_parameters(a, i, static_cast<std::size_t>(rows)));
    }
  }
  return pieces;
}

/// Coordinate d of the polar form of a cubic; its control points are its values at (lo, lo, lo), .., and the
/// points themselves at the ends.
double polar(const std::array<std::span<const double>, 4>& p, std::size_t d, double r, double s, double t) {
  const auto mix = [](double x, double y, double at) { return (1.0 - at) * x + at * y; };
  const double x = mix(p[0][d], p[1][d], r);
  const double y = mix(p[1][d], p[2][d], r);
  const double z = mix(p[2][d], p[3][d], r);
  return mix(mix(x, y, s), mix(y, z, s), t);
}

CubicPath redraw(const CubicPath& path, const std::vector<SegmentPiece>& pieces, bool closed) {
  Points points(path.dim(), 3 * pieces.size() + 1);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto segment = path.segment(pieces[k].segment);
    const double from = pieces[k].from;
    const double to = pieces[k].to;
    for (std::size_t d = 0; d < segment[0].size(); ++d) {
      points[3 * k][d] = polar(segment, d, from, from, from);
      points[3 * k + 1][d] = polar(segment, d, from, from, to);
      points[3 * k + 2][d] = polar(segment, d, from, to, to);
      points[3 * k + 3][d] = polar(segment, d, to, to, to);
    }
  }
  return CubicPath(std::move(points), closed);
}

/// The parameters of the pieces' ends, running on past the path's end: one more than pieces.
std::vector<double> parameters(const std::vector<SegmentPiece>& pieces, std::size_t segments) {
  std::vector<double> at;
  double lap = 0.0;
  for (const SegmentPiece& piece : pieces) {
    double t = lap + (static_cast<double>(piece.segment) + piece.from);
    if (!at.empty() && t < at.back()) {
      lap += static_cast<double>(segments);
      t += static_cast<double>(segments);
    }
    at.push_back(t);
  }
  at.push_back(lap + (static_cast<double>(pieces.back().segment) + pieces.back().to));
  return at;
}

Correspondence correspondence_of(const Pieces& pieces, const CubicPath& a, const CubicPath& b, Loops loops,
                                 bool reversed) {
  const std::vector<double> u = parameters(pieces.a, a.segment_count());
  const std::vector<double> v = parameters(pieces.b, b.segment_count());
  const double last_v = static_cast<double>(b.segment_count());
  Correspondence c;
  for (std::size_t k = 0; k < u.size(); ++k) c.points.push_back({u[k], reversed ? last_v - v[k] : v[k]});
  c.closed = loops.a && loops.b;
  c.reversed = reversed;
  c.domain_u = {0.0, static_cast<double>(a.segment_count())};
  c.domain_v = {0.0, last_v};
  if (loops.a && !loops.b) c.domain_u = {c.points.front().u, c.points.back().u};
  if (loops.b && !loops.a) {
    c.domain_v = {std::min(c.points.front().v, c.points.back().v),
                  std::max(c.points.front().v, c.points.back().v)};
  }
  return c;
}

Loops choose_loops(const CubicPath& a, const CubicPath& b, ClosedMode mode) {
  switch (mode) {
    case ClosedMode::no:
      return {false, false};
    case ClosedMode::pinned:
      throw InvalidArgument(
          "the segments method has no pinned form for closed curves, expected automatic, yes or no");
    case ClosedMode::yes:
      if (!a.is_closed() || !b.is_closed()) {
        throw InvalidArgument(std::string("the ") + (a.is_closed() ? "second" : "first") +
                              " curve is open; matching as loops needs two closed curves");
      }
      break;
    case ClosedMode::automatic:
      break;
  }
  return {a.is_closed(), b.is_closed()};
}

/// Joints of b between the starts of the two paths, in [0, n).
int shift_of(const Node& first, std::size_t segments_a, std::size_t segments_b) {
  const double ratio = static_cast<double>(segments_b) / static_cast<double>(segments_a);
  const int along = static_cast<int>(std::floor(first.i * ratio + 0.5));
  return static_cast<int>(wrap(first.j - along, segments_b));
}

}  // namespace

SegmentMatch match_segments(const CubicPath& a, const CubicPath& b, const SegmentOptions& options) {
  if (a.dim() != b.dim()) {
    throw InvalidArgument("the curves have different dimensions: the first has " + std::to_string(a.dim()) +
                          ", the second " + std::to_string(b.dim()));
  }
  if (options.longest_run < 0) {
    throw InvalidArgument("the longest run is " + std::to_string(options.longest_run) +
                          ", expected a number of segments, or 0 for any");
  }
  const Loops loops = choose_loops(a, b, options.closed);
  FoundSegments found = detail::search_segments(a, b, loops, options);
  if (found.cancelled) {
    SegmentMatch cancelled{a, b, {}, {}};
    cancelled.cancelled = true;
    return cancelled;
  }
  // Only ratios of lengths count here.
  const SegmentVectors vectors_a = detail::segment_vectors(a, options.split, 1.0);
  const SegmentVectors vectors_b = detail::segment_vectors(b, options.split, 1.0);
  Pieces pieces = cut(found.path, vectors_a, found.reversed ? detail::reversed(vectors_b) : vectors_b);
  if (loops.a && loops.b) {
    const auto first = static_cast<std::ptrdiff_t>(pieces.first);
    std::rotate(pieces.a.begin(), pieces.a.begin() + first, pieces.a.end());
    std::rotate(pieces.b.begin(), pieces.b.begin() + first, pieces.b.end());
  }
  Correspondence correspondence = correspondence_of(pieces, a, b, loops, found.reversed);
  if (found.reversed) {
    for (SegmentPiece& piece : pieces.b) {
      piece = {b.segment_count() - 1 - piece.segment, 1.0 - piece.from, 1.0 - piece.to};
    }
  }
  const bool closed = a.is_closed() && b.is_closed();
  SegmentMatch match{redraw(a, pieces.a, closed), redraw(b, pieces.b, closed), std::move(pieces.a),
                     std::move(pieces.b)};
  match.cost = found.cost;
  match.direction = found.reversed ? Direction::reversed : Direction::forward;
  if (loops.a || loops.b) {
    match.shift = shift_of(found.path.front(), a.segment_count(), b.segment_count());
  }
  match.path = std::move(found.path);
  match.correspondence = std::move(correspondence);
  return match;
}

}  // namespace v0
}  // namespace tandem
