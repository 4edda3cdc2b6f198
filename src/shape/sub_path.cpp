#include "shape/sub_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

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

class PieceBuilder {
 public:
  explicit PieceBuilder(Vec2 start) { push(start); }

  void add(const Cubic& c, bool chord) {
    for (std::size_t k = 1; k < 4; ++k) push(c[k]);
    chords_.push_back(chord);
  }
  // Parts of a segment end where the other piece's part begins, to the last bit.
  void end_at(Vec2 p) {
    points_[points_.size() - 1][0] = p.x;
    points_[points_.size() - 1][1] = p.y;
  }
  CutPiece close() {
    const Vec2 a{points_[points_.size() - 1][0], points_[points_.size() - 1][1]};
    const Vec2 b{points_[0][0], points_[0][1]};
    add({a, {third(a.x, b.x), third(a.y, b.y)}, {third(b.x, a.x), third(b.y, a.y)}, b}, true);
    return {CubicPath(std::move(points_), true), std::move(chords_)};
  }

 private:
  void push(Vec2 p) { points_.push_back(std::array{p.x, p.y}); }

  Points points_;
  std::vector<bool> chords_;
};

}  // namespace

Vec2 point_at(const CubicPath& path, double u) {
  const auto [segment, t] = locate(path, u);
  return t == 0.0 ? segment_of(path, segment)[0] : split(segment_of(path, segment), t).first[3];
}

CutPiece close_by_chord(const CutPiece& piece, double u, double v) {
  const Location from = locate(piece.path, u);
  const Location to = locate(piece.path, v);
  const std::size_t count = piece.path.segment_count();
  PieceBuilder builder(point_at(piece.path, u));
  if (from.segment == to.segment && u < v) {
    const Cubic head = split(segment_of(piece.path, to.segment), to.t).first;
    builder.add(from.t == 0.0 ? head : split(head, from.t / to.t).second, piece.chords[from.segment]);
  } else {
    const Cubic whole = segment_of(piece.path, from.segment);
    builder.add(from.t == 0.0 ? whole : split(whole, from.t).second, piece.chords[from.segment]);
    for (std::size_t i = (from.segment + 1) % count; i != to.segment; i = (i + 1) % count) {
      builder.add(segment_of(piece.path, i), piece.chords[i]);
    }
    if (to.t > 0.0) {
      builder.add(split(segment_of(piece.path, to.segment), to.t).first, piece.chords[to.segment]);
    }
  }
  builder.end_at(point_at(piece.path, v));
  return builder.close();
}

}  // namespace v0
}  // namespace tandem
