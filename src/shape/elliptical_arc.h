#pragma once

#include <vector>

#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {

/// An arc as SVG writes it: end points, radii and flags.
struct EllipticalArc {
  Vec2 from;
  Vec2 radii;
  double x_axis_rotation_degrees = 0.0;
  bool large = false;
  bool sweep = false;
  Vec2 to;
};

/// One cubic of an arc; it starts where the piece before it ends.
struct ArcPiece {
  Vec2 control1;
  Vec2 control2;
  Vec2 end;
};

/// The arc as cubics of equal angle, at most 45 degrees each; the last one ends at `to` exactly. Empty where
/// the arc is a straight line: a radius is zero (or vanishes beside the other one or beside the chord's
/// length). Source: SVG 2, appendix B.2. The angles themselves are never computed: half the sweep has the
/// sine |h|, h being half the chord in the frame where the ellipse is the unit circle, and pieces come from
/// halving.
[[nodiscard]] std::vector<ArcPiece> arc_pieces(const EllipticalArc& arc);

}  // namespace v0
}  // namespace tandem
