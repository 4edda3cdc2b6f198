#include "shape/sub_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "shape/plane.h"
#include "shape/third.h"

namespace tandem {
inline namespace v0 {
namespace {

using Cubic = std::array<Vec2, 4>;

double lerp(double x, double y, double t) {
  return (1.0 - t) * x + t * y;
}

Vec2 between(Vec2 a, Vec2 b, double t) {
  return {lerp(a.x, b.x, t), lerp(a.y, b.y, t)};
}

/// The polar form of one coordinate of a cubic: affine in each argument. The control points of the part from
/// r to t are its values at (r, r, r), (r, r, t), (r, t, t) and (t, t, t).
double polar(const std::array<double, 4>& p, double r, double s, double t) {
  const double x = lerp(p[0], p[1], r);
  const double y = lerp(p[1], p[2], r);
  const double z = lerp(p[2], p[3], r);
  return lerp(lerp(x, y, s), lerp(y, z, s), t);
}

std::array<double, 4> coordinate(const CubicPath& path, std::size_t segment, std::size_t c) {
  const auto p = path.segment(segment);
  return {p[0][c], p[1][c], p[2][c], p[3][c]};
}

Cubic part_of(const CubicPath& path, std::size_t segment, double from, double to) {
  const std::array<double, 4> x = cubic_part(coordinate(path, segment, 0), from, to);
  const std::array<double, 4> y = cubic_part(coordinate(path, segment, 1), from, to);
  return {{{x[0], y[0]}, {x[1], y[1]}, {x[2], y[2]}, {x[3], y[3]}}};
}

struct Location {
  std::size_t segment = 0;
  double t = 0.0;
};

Location locate(const CubicPath& path, double u) {
  const auto last = static_cast<double>(path.segment_count() - 1);
  const double segment = std::min(std::floor(u), last);
  return {static_cast<std::size_t>(segment), u - segment};
}

struct Segment {
  Cubic path;
  Cubic outline;
  bool chord = false;
};

Cubic line(Vec2 a, Vec2 b) {
  return {a, {third(a.x, b.x), third(a.y, b.y)}, {third(b.x, a.x), third(b.y, a.y)}, b};
}

// The part of a path from u on to v, past its last joint when v < u. Its ends are the points there to the
// bit, so that pieces on both sides of a cut meet.
std::vector<Cubic> part_of(const CubicPath& path, double u, double v) {
  const Location from = locate(path, u);
  const Location to = locate(path, v);
  if (from.segment == to.segment && u < v) return {part_of(path, from.segment, from.t, to.t)};
  std::vector<Cubic> part{part_of(path, from.segment, from.t, 1.0)};
  for (std::size_t i = (from.segment + 1) % path.segment_count(); i != to.segment;
       i = (i + 1) % path.segment_count()) {
    part.push_back(part_of(path, i, 0.0, 1.0));
  }
  if (to.t > 0.0) part.push_back(part_of(path, to.segment, 0.0, to.t));
  return part;
}

std::vector<Segment> part_of(const CutPiece& piece, double u, double v) {
  const std::vector<Cubic> path = part_of(piece.path, u, v);
  const std::vector<Cubic> outline = piece.outline ? part_of(*piece.outline, u, v) : path;
  const std::size_t first = locate(piece.path, u).segment;
  std::vector<Segment> part;
  for (std::size_t i = 0; i < path.size(); ++i) {
    part.push_back({path[i], outline[i], piece.chords[(first + i) % piece.chords.size()]});
  }
  return part;
}

Segment reversed(const Segment& segment) {
  const auto turn = [](const Cubic& c) { return Cubic{c[3], c[2], c[1], c[0]}; };
  return {turn(segment.path), turn(segment.outline), segment.chord};
}

// The chord along which a part is cut off, with as many segments as the part, each pushed out onto its own.
std::vector<Segment> chord_under(const std::vector<Segment>& part) {
  std::vector<double> ends{0.0};
  for (const Segment& segment : part) {
    double length = 0.0;
    for (std::size_t k = 0; k < 3; ++k) length += distance(segment.path[k], segment.path[k + 1]);
    ends.push_back(ends.back() + length);
  }
  const Vec2 a = part.front().path[0];
  const Vec2 b = part.back().path[3];
  std::vector<Segment> chord;
  Vec2 from = a;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Vec2 to = i + 1 < part.size() ? between(a, b, ends[i + 1] / ends.back()) : b;
    chord.push_back({line(from, to), part[i].outline, true});
    from = to;
  }
  return chord;
}

CutPiece to_piece(const std::vector<Segment>& segments, bool with_outline) {
  Points path;
  Points outline;
  CutPiece piece{CubicPath(Points(2, 4)), {}};
  const auto push = [](Points& points, Vec2 p) { points.push_back(std::array{p.x, p.y}); };
  push(path, segments.front().path[0]);
  push(outline, segments.front().outline[0]);
  for (const Segment& segment : segments) {
    for (std::size_t k = 1; k < 4; ++k) push(path, segment.path[k]);
    for (std::size_t k = 1; k < 4; ++k) push(outline, segment.outline[k]);
    piece.chords.push_back(segment.chord);
  }
  piece.path = CubicPath(std::move(path), true);
  if (with_outline) piece.outline = CubicPath(std::move(outline), true);
  return piece;
}

}  // namespace

double cubic_at(const std::array<double, 4>& p, double t) {
  if (t == 0.0) return p[0];
  if (t == 1.0) return p[3];
  return polar(p, t, t, t);
}

std::array<double, 4> cubic_part(const std::array<double, 4>& p, double from, double to) {
  return {cubic_at(p, from), polar(p, from, from, to), polar(p, from, to, to), cubic_at(p, to)};
}

CubicPath join_parts(const CubicPath& path, std::span<const SegmentPart> parts, bool closed) {
  Points points(path.dim(), 3 * parts.size() + 1);
  for (std::size_t c = 0; c < static_cast<std::size_t>(path.dim()); ++c) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const SegmentPart& part = parts[k];
      const std::array<double, 4> cut = cubic_part(coordinate(path, part.segment, c), part.from, part.to);
      for (std::size_t i = k == 0 ? 0 : 1; i < 4; ++i) points[3 * k + i][c] = cut[i];
    }
  }
  if (closed) {  // the ends meet up to rounding only
    const auto front = std::as_const(points).front();
    std::copy(front.begin(), front.end(), points[points.size() - 1].begin());
  }
  return CubicPath(std::move(points), closed);
}

Vec2 point_at(const CubicPath& path, double u) {
  const auto [segment, t] = locate(path, u);
  return {cubic_at(coordinate(path, segment, 0), t), cubic_at(coordinate(path, segment, 1), t)};
}

Halves cut_by_chord(const CutPiece& piece, double u, double v) {
  const auto half = [&](double from, double to) {
    std::vector<Segment> part = part_of(piece, from, to);
    const Segment& last = part.back();
    const Segment& first = part.front();
    part.push_back({line(last.path[3], first.path[0]), line(last.outline[3], first.outline[0]), true});
    return to_piece(part, piece.outline.has_value());
  };
  return {half(u, v), half(v, u)};
}

Halves cut_and_push(const CutPiece& piece, double u, double v, bool onto_first) {
  std::vector<Segment> bud = onto_first ? part_of(piece, u, v) : part_of(piece, v, u);
  std::vector<Segment> rest = onto_first ? part_of(piece, v, u) : part_of(piece, u, v);
  const std::vector<Segment> chord = chord_under(bud);
  rest.insert(rest.end(), chord.begin(), chord.end());
  for (std::size_t i = chord.size(); i-- > 0;) bud.push_back(reversed(chord[i]));
  CutPiece cut_off = to_piece(bud, true);
  CutPiece left = to_piece(rest, true);
  if (onto_first) return {std::move(cut_off), std::move(left)};
  return {std::move(left), std::move(cut_off)};
}

}  // namespace v0
}  // namespace tandem
