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

Vec2 blend(Vec2 a, Vec2 b, double t) {
  return {(1.0 - t) * a.x + t * b.x, (1.0 - t) * a.y + t * b.y};
}

Cubic segment_of(const CubicPath& path, std::size_t i) {
  Cubic cubic;
  for (std::size_t k = 0; k < 4; ++k) cubic[k] = {path.segment(i)[k][0], path.segment(i)[k][1]};
  return cubic;
}

std::pair<Cubic, Cubic> split(const Cubic& c, double t) {
  const Vec2 p01 = blend(c[0], c[1], t);
  const Vec2 p12 = blend(c[1], c[2], t);
  const Vec2 p23 = blend(c[2], c[3], t);
  const Vec2 q = blend(p01, p12, t);
  const Vec2 r = blend(p12, p23, t);
  const Vec2 m = blend(q, r, t);
  return {{c[0], p01, q, m}, {m, r, p23, c[3]}};
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

// The part of a path from u on to v, past its last joint when v < u.
std::vector<Cubic> part_of(const CubicPath& path, double u, double v) {
  const Location from = locate(path, u);
  const Location to = locate(path, v);
  std::vector<Cubic> part;
  if (from.segment == to.segment && u < v) {
    const Cubic head = split(segment_of(path, to.segment), to.t).first;
    part.push_back(from.t == 0.0 ? head : split(head, from.t / to.t).second);
  } else {
    const Cubic whole = segment_of(path, from.segment);
    part.push_back(from.t == 0.0 ? whole : split(whole, from.t).second);
    for (std::size_t i = (from.segment + 1) % path.segment_count(); i != to.segment;
         i = (i + 1) % path.segment_count()) {
      part.push_back(segment_of(path, i));
    }
    if (to.t > 0.0) part.push_back(split(segment_of(path, to.segment), to.t).first);
  }
  // Parts of a segment end where the other piece's part begins, to the last bit.
  part.front()[0] = point_at(path, u);
  part.back()[3] = point_at(path, v);
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
    const Vec2 to = i + 1 < part.size() ? blend(a, b, ends[i + 1] / ends.back()) : b;
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

Vec2 point_at(const CubicPath& path, double u) {
  const auto [segment, t] = locate(path, u);
  return t == 0.0 ? segment_of(path, segment)[0] : split(segment_of(path, segment), t).first[3];
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
