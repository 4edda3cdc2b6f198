#pragma once

#include <vector>

#include "tandem/shape/cut.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {

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
