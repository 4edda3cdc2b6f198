#include "shape/elliptical_arc.h"

#include <algorithm>
#include <cmath>

#include "shape/trigonometry.h"

namespace tandem {
inline namespace v0 {
namespace {

// cos(22.5 degrees), a hair less so that arcs of exactly 45, 90, 180 degrees are not halved once more by
// rounding.
constexpr double kCosHalfPiece = 0.92387953251128674 - 1e-12;

// Ratios beyond this make no ellipse: their squares must neither over- nor underflow.
constexpr double kFlat = 1e-140;

CosSin halve(CosSin t) {
  // The larger of the two is the one whose square root loses nothing.
  if (t.cosine >= 0.0) {
    const double c = std::sqrt((1.0 + t.cosine) / 2.0);
    return {c, t.sine / (2.0 * c)};
  }
  const double s = std::sqrt((1.0 - t.cosine) / 2.0);
  return {t.sine / (2.0 * s), s};
}

}  // namespace

std::vector<ArcPiece> arc_pieces(const EllipticalArc& arc) {
  const CosSin axis = cos_sin_degrees(arc.x_axis_rotation_degrees);
  const Vec2 half{arc.from.x / 2.0 - arc.to.x / 2.0, arc.from.y / 2.0 - arc.to.y / 2.0};
  const Vec2 chord{axis.cosine * half.x + axis.sine * half.y, axis.cosine * half.y - axis.sine * half.x};
  const double scale = std::max(std::fabs(chord.x), std::fabs(chord.y));
  double rx = std::fabs(arc.radii.x);
  double ry = std::fabs(arc.radii.y);
  if (!(scale > 0.0 && std::isfinite(scale) && std::isfinite(rx) && std::isfinite(ry))) return {};
  const double larger = std::max(rx, ry);
  if (!(std::min(rx, ry) > kFlat * larger)) return {};
  if (larger < kFlat * scale) {  // far too small: only the ratio of the radii matters
    rx = rx / larger * scale;
    ry = ry / larger * scale;
  }

  Vec2 h{chord.x / rx, chord.y / ry};  // half the chord where the ellipse is the unit circle
  double sine = std::sqrt(h.x * h.x + h.y * h.y);
  if (!(sine > kFlat)) return {};
  const Vec2 direction{h.x / sine, h.y / sine};
  if (sine > 1.0) {  // B.2.5: radii too small for the chord grow until they reach
    rx *= sine;
    ry *= sine;
    sine = 1.0;
    h = direction;
  }
  const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
  const double side = arc.large != arc.sweep ? cosine : -cosine;
  const Vec2 center{side * direction.y, -side * direction.x};

  CosSin piece{arc.large ? -cosine : cosine, sine};  // half the angle of a piece
  int count = 1;
  while (piece.cosine < kCosHalfPiece) {
    piece = halve(piece);
    count *= 2;
  }
  const double turn = arc.sweep ? 1.0 : -1.0;
  const double handle = turn * (4.0 / 3.0) * (piece.sine / (1.0 + piece.cosine));
  const double step_c = (piece.cosine - piece.sine) * (piece.cosine + piece.sine);
  const double step_s = turn * 2.0 * piece.cosine * piece.sine;

  const Vec2 middle{arc.from.x / 2.0 + arc.to.x / 2.0, arc.from.y / 2.0 + arc.to.y / 2.0};
  const auto offset = [&](Vec2 base, Vec2 q, double times) {  // base + times q, q on the unit circle
    const Vec2 e{times * rx * q.x, times * ry * q.y};
    return Vec2{base.x + (axis.cosine * e.x - axis.sine * e.y),
                base.y + (axis.sine * e.x + axis.cosine * e.y)};
  };
  std::vector<ArcPiece> pieces;
  Vec2 q{h.x - center.x, h.y - center.y};
  Vec2 start = arc.from;
  for (int i = 0; i < count; ++i) {
    const Vec2 next{step_c * q.x - step_s * q.y, step_s * q.x + step_c * q.y};
    const Vec2 end = i + 1 == count ? arc.to : offset(middle, {next.x + center.x, next.y + center.y}, 1.0);
    // Handles are laid off from the end points: under huge radii the circle's own centre is far away.
    pieces.push_back({offset(start, {-q.y, q.x}, handle), offset(end, {next.y, -next.x}, handle), end});
    q = next;
    start = end;
  }
  return pieces;
}

}  // namespace v0
}  // namespace tandem
