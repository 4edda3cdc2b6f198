#pragma once

#include <optional>

#include "surface/cells.h"
#include "surface/enclosed_surface.h"
#include "surface/findings.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A place of a surface in space within 1e-6 of the span of which S_u x S_v is zero somewhere, proved; looked
/// for from the middle of a piece.
///
/// Why. Where the coordinate c of S_u has one sign, S_u x S_v is zero as soon as its two other coordinates
/// are, since it is perpendicular to S_u (or S_v, likewise). That is two equations in u and v, and where they
/// are solved one by one across a cell - one has different signs on the sides u = const, the other on the
/// sides v = const, after a change of basis - they are solved together somewhere inside (the theorem of
/// Poincare and Miranda). The signs are those of Bernstein coefficients. Such points are what is stable of
/// singularities in space (Whitney 1943); others move apart, or away, with the last bit of a coefficient.
[[nodiscard]] std::optional<Parameters> singular_point(const EnclosedSurface& surface,
                                                       const CellPiece& piece);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
