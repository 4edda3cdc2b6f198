#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tandem/shape/cubic_path.h"
#include "tandem/shape/cut.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {

/// A part of a segment of a path: from > to where it runs backwards. Both in [0, 1].
struct SegmentPart {
  std::size_t segment = 0;
  double from = 0.0;
  double to = 1.0;
};

/// One coordinate of a cubic at t, from those of its control points; at 0 and 1 the ends to the bit.
[[nodiscard]] double cubic_at(const std::array<double, 4>& p, double t);

/// One coordinate of the control points of the part of a cubic; ends at 0 and 1 are the cubic's to the bit.
[[nodiscard]] std::array<double, 4> cubic_part(const std::array<double, 4>& p, double from, double to);

/// The path through these parts, each of which begins where the one before it ends.
/// parts: at least one; closed: the last one ends where the first begins.
[[nodiscard]] CubicPath join_parts(const CubicPath& path, std::span<const SegmentPart> parts, bool closed);

/// The point of a planar path at u in [0, segment_count].
[[nodiscard]] Vec2 point_at(const CubicPath& path, double u);

/// The part of a closed piece from u on to v (past its last joint when v < u), closed by a chord.
/// u != v, both in [0, segment_count).
[[nodiscard]] CutPiece close_by_chord(const CutPiece& piece, double u, double v);

}  // namespace v0
}  // namespace tandem
