#include "shape/sub_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "shape/plane.h"
#include "shape/third.h"

namespace tandem {
inline namespace v0 {
namespace {

// Cubics are the same when their control points differ by less, in lengths of the outline.
constexpr double kRetraced = 1e-9;

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

Cubic reversed(const Cubic& c) {
  return {c[3], c[2], c[1], c[0]};
}

Segment reversed(const Segment& segment) {
  return {reversed(segment.path), reversed(segment.outline), segment.chord};
}

double polygon_length(const Cubic& c) {
  return distance(c[0], c[1]) + distance(c[1], c[2]) + distance(c[2], c[3]);
}

Cubic sub_cubic(const Cubic& c, double from, double to) {
  const auto x = cubic_part(std::array<double, 4>{c[0].x, c[1].x, c[2].x, c[3].x}, from, to);
  const auto y = cubic_part(std::array<double, 4>{c[0].y, c[1].y, c[2].y, c[3].y}, from, to);
  return {{{x[0], y[0]}, {x[1], y[1]}, {x[2], y[2]}, {x[3], y[3]}}};
}

// Whether two cubics are the same, in units of `size`.
bool agree(const Cubic& a, const Cubic& b, double size) {
  double off = 0.0;
  for (std::size_t k = 0; k < 4; ++k) off = std::max(off, distance(a[k], b[k]));
  return off <= kRetraced * size;
}

// The share of `longer`, from its end, that `shorter` runs back along; nothing when it does not.
std::optional<double> retraced(const Cubic& longer, const Cubic& shorter, double size) {
  double lo = 0.0;
  double hi = 1.0;
  const double wanted = polygon_length(shorter);
  for (int i = 0; i < 60; ++i) {  // of parts of one end the control polygon grows with the part
    const double mid = 0.5 * (lo + hi);
    (polygon_length(sub_cubic(longer, 1.0 - mid, 1.0)) < wanted ? lo : hi) = mid;
  }
  if (!agree(sub_cubic(longer, 1.0 - hi, 1.0), reversed(shorter), size)) return std::nullopt;
  return hi;
}

// An outline without what it runs along forth and back: a part that is pushed out onto the outline is
// doubled, and from one of its sides to the other there is no need to go round its end.
std::vector<Cubic> direct(const std::vector<Segment>& part) {
  double size = 0.0;
  for (const Segment& segment : part) size += polygon_length(segment.outline);
  std::vector<Cubic> way;
  for (const Segment& segment : part) {
    Cubic next = segment.outline;
    bool gone = false;
    while (!way.empty() && !gone) {
      Cubic& last = way.back();
      if (polygon_length(last) >= polygon_length(next)) {
        const auto share = retraced(last, next, size);
        if (!share) break;
        gone = true;
        last = sub_cubic(last, 0.0, 1.0 - *share);
        if (polygon_length(last) <= kRetraced * size) way.pop_back();
      } else {
        const auto share = retraced(reversed(next), reversed(last), size);
        if (!share) break;
        next = sub_cubic(next, *share, 1.0);
        way.pop_back();
      }
    }
    if (!gone) way.push_back(next);
  }
  if (way.empty())
    way.push_back(
        {part.front().outline[0], part.front().outline[0], part.back().outline[3], part.back().outline[3]});
  way.front()[0] = part.front().outline[0];
  way.back()[3] = part.back().outline[3];
  return way;
}

// The chord along which a part is cut off, in as many segments as it takes to push it out onto the part.
std::vector<Segment> chord_under(const std::vector<Segment>& part) {
  const std::vector<Cubic> way = direct(part);
  // Each as long as what it is pushed onto, as the key is drawn.
  std::vector<double> ends{0.0};
  if (way.size() == part.size()) {
    for (const Segment& segment : part) ends.push_back(ends.back() + polygon_length(segment.path));
  } else {
    for (const Cubic& cubic : way) ends.push_back(ends.back() + polygon_length(cubic));
  }
  const Vec2 a = part.front().path[0];
  const Vec2 b = part.back().path[3];
  std::vector<Segment> chord;
  Vec2 from = a;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Vec2 to = i + 1 < way.size() ? between(a, b, ends[i + 1] / ends.back()) : b;
    chord.push_back({line(from, to), way[i], true});
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
