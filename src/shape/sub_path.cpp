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

double lerp(double x, double y, double t) {
  return (1.0 - t) * x + t * y;
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

class PieceBuilder {
 public:
  explicit PieceBuilder(Vec2 start) { push(start); }

  void add(const Cubic& c, bool chord) {
    for (std::size_t k = 1; k < 4; ++k) push(c[k]);
    chords_.push_back(chord);
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

CutPiece close_by_chord(const CutPiece& piece, double u, double v) {
  const Location from = locate(piece.path, u);
  const Location to = locate(piece.path, v);
  const std::size_t count = piece.path.segment_count();
  PieceBuilder builder(point_at(piece.path, u));
  const auto add = [&](std::size_t segment, double first, double last) {
    builder.add(part_of(piece.path, segment, first, last), piece.chords[segment]);
  };
  if (from.segment == to.segment && u < v) {
    add(from.segment, from.t, to.t);
  } else {
    add(from.segment, from.t, 1.0);
    for (std::size_t i = (from.segment + 1) % count; i != to.segment; i = (i + 1) % count) add(i, 0.0, 1.0);
    if (to.t > 0.0) add(to.segment, 0.0, to.t);
  }
  return builder.close();
}

}  // namespace v0
}  // namespace tandem
