#pragma once

#include <numbers>

#include "tandem/match/norm.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// What one ruling does: the segment from a point of the first rail to its partner on the second, between
/// unit tangents of both.
struct Ruling {
  /// The angle between the surface's tangent planes at the ruling's two ends, in radians, in [0, pi]: 0 where
  /// the strip is developable, above pi/2 where it twists. It is the angle between the parts of the two
  /// tangents across the ruling; its sine is det(T1, T2, d), these parts and d made unit vectors.
  double warp = 0.0;
  /// How far the ruling leans out of the plane normal to the rails, in radians, in [0, pi/2]: the angle whose
  /// sine is <d, T>, T along T1 + T2.
  double inclination = 0.0;
};

/// In R^n. A ruling of no length, and tangents along it, have no warp; tangents that cancel no inclination.
[[nodiscard]] TANDEM_EXPORT Ruling ruling_of(const NormArguments& pair);

/// The norm of surfaces as developable as possible: the cost is 1 - cos of the ruling's warp angle; a warp
/// above pi/2 and an inclination above the limit are invalid. Symmetric.
[[nodiscard]] TANDEM_EXPORT UserNorm developable_norm(double largest_inclination = std::numbers::pi / 2);

}  // namespace v0
}  // namespace tandem
