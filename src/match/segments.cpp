#include "tandem/match/segments.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "match/pinned_path.h"
#include "match/segment_runs.h"
#include "match/segment_search.h"
#include "shape/sub_path.h"
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

CubicPath redraw(const CubicPath& path, const std::vector<SegmentPiece>& pieces, bool closed) {
  std::vector<SegmentPart> parts;
  parts.reserve(pieces.size());
  for (const SegmentPiece& piece : pieces) parts.push_back({piece.segment, piece.from, piece.to});
  return join_parts(path, parts, closed);
}

/// The parameters of the pieces' ends, running on past the path's end (before its start where they fall): one
/// more than pieces.
std::vector<double> parameters(const std::vector<SegmentPiece>& pieces, std::size_t segments, bool falling) {
  const double period = falling ? -static_cast<double>(segments) : static_cast<double>(segments);
  std::vector<double> at;
  double lap = 0.0;
  for (const SegmentPiece& piece : pieces) {
    double t = lap + (static_cast<double>(piece.segment) + piece.from);
    if (!at.empty() && (falling ? t > at.back() : t < at.back())) {
      lap += period;
      t += period;
    }
    at.push_back(t);
  }
  at.push_back(lap + (static_cast<double>(pieces.back().segment) + pieces.back().to));
  return at;
}

/// Of pieces of the paths as they were.
Correspondence correspondence_of(const Pieces& pieces, const CubicPath& a, const CubicPath& b, Loops loops,
                                 bool reversed) {
  const std::vector<double> u = parameters(pieces.a, a.segment_count(), false);
  const std::vector<double> v = parameters(pieces.b, b.segment_count(), reversed);
  const double last_v = static_cast<double>(b.segment_count());
  Correspondence c;
  for (std::size_t k = 0; k < u.size(); ++k) c.points.push_back({u[k], v[k]});
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

/// Both paths with joints at their pins.
struct PinnedPaths {
  detail::PinnedPath a;
  detail::PinnedPath b;
  std::vector<Node> pins;
};

PinnedPaths split_at_pins(const CubicPath& a, const CubicPath& b, Loops loops,
                          const std::vector<ParameterPair>& pins) {
  std::vector<double> on_a;
  std::vector<double> on_b;
  for (const ParameterPair& pin : pins) {
    const auto inside = [](double t, const CubicPath& path) {
      return t >= 0.0 && t <= static_cast<double>(path.segment_count());
    };
    if (!inside(pin.u, a) || !inside(pin.v, b)) {
      throw InvalidArgument("a pin is at u = " + std::to_string(pin.u) + ", v = " + std::to_string(pin.v) +
                            ", expected parameters of the paths: within [0, " +
                            std::to_string(a.segment_count()) + "] and [0, " +
                            std::to_string(b.segment_count()) + "]");
    }
    on_a.push_back(pin.u);
    on_b.push_back(pin.v);
  }
  PinnedPaths split{detail::split_at_pins(a, on_a, loops.a), detail::split_at_pins(b, on_b, loops.b), {}};
  for (std::size_t k = 0; k < pins.size(); ++k) {
    split.pins.push_back({static_cast<int>(split.a.pins[k]), static_cast<int>(split.b.pins[k])});
  }
  return split;
}

/// What belongs together along the path, in pieces of the split paths; reversed ones run backwards.
Pieces pieces_along(const FoundSegments& found, const PinnedPaths& split, Loops loops, SegmentSplit rule) {
  // Only ratios of lengths count here.
  const SegmentVectors a = detail::segment_vectors(split.a.path, rule, 1.0);
  const SegmentVectors b = detail::segment_vectors(split.b.path, rule, 1.0);
  Pieces pieces = cut(found.path, a, found.reversed ? detail::reversed(b) : b);
  if (loops.a && loops.b) {
    const auto first = static_cast<std::ptrdiff_t>(pieces.first);
    std::rotate(pieces.a.begin(), pieces.a.begin() + first, pieces.a.end());
    std::rotate(pieces.b.begin(), pieces.b.begin() + first, pieces.b.end());
  }
  if (found.reversed) {
    for (SegmentPiece& piece : pieces.b)
      piece = {b.size() - 1 - piece.segment, 1.0 - piece.from, 1.0 - piece.to};
  }
  return pieces;
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
  const PinnedPaths split = split_at_pins(a, b, loops, options.pins);
  FoundSegments found = detail::search_segments(split.a.path, split.b.path, loops, split.pins, options);
  if (found.cancelled) {
    SegmentMatch cancelled{a, b, {}, {}};
    cancelled.cancelled = true;
    return cancelled;
  }
  Pieces pieces = pieces_along(found, split, loops, options.split);
  for (SegmentPiece& piece : pieces.a) piece = split.a.original(piece);
  for (SegmentPiece& piece : pieces.b) piece = split.b.original(piece);
  Correspondence correspondence = correspondence_of(pieces, a, b, loops, found.reversed);
  const bool closed = a.is_closed() && b.is_closed();
  SegmentMatch match{redraw(a, pieces.a, closed), redraw(b, pieces.b, closed), std::move(pieces.a),
                     std::move(pieces.b)};
  match.cost = found.cost;
  match.direction = found.reversed ? Direction::reversed : Direction::forward;
  if (loops.a || loops.b) {
    match.shift = shift_of(found.path.front(), split.a.path.segment_count(), split.b.path.segment_count());
  }
  match.path = std::move(found.path);
  match.correspondence = std::move(correspondence);
  return match;
}

}  // namespace v0
}  // namespace tandem
