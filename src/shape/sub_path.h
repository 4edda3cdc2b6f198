#pragma once

#include <vector>

#include "tandem/shape/cut.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {

/// The point of a planar path at u in [0, segment_count].
[[nodiscard]] Vec2 point_at(const CubicPath& path, double u);

/// The part of a closed piece from u on to v (past its last joint when v < u), closed by a chord.
/// u != v, both in [0, segment_count).
[[nodiscard]] CutPiece close_by_chord(const CutPiece& piece, double u, double v);

}  // namespace v0
}  // namespace tandem
