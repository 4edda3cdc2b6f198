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

/// Both sides of a chord: first that from u on to v, then that from v on to u.
struct Halves {
  CutPiece first;
  CutPiece second;
};

/// A closed piece cut along the chord between u and v.
/// u != v, both in [0, segment_count).
[[nodiscard]] Halves cut_by_chord(const CutPiece& piece, double u, double v);

/// The same of a piece with an outline: the chord is pushed out onto the outline of the first half (if
/// `onto_first`), else of the second; that half then is a part of the outline forth and back.
[[nodiscard]] Halves cut_and_push(const CutPiece& piece, double u, double v, bool onto_first);

}  // namespace v0
}  // namespace tandem
