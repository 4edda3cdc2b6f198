#pragma once

#include <span>
#include <vector>

#include "tandem/curve/points.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// A cubic segment in Hermite form: its end points, and its derivatives there by a parameter over [0, 1].
/// Source: [D] section 2.2; in Bezier form the handles are a third of the tangents.
struct HermiteSegment {
  Point start;
  Point end;
  Point start_tangent;  ///< 3 (P1 - P0)
  Point end_tangent;    ///< 3 (P3 - P2)
  friend bool operator==(const HermiteSegment&, const HermiteSegment&) = default;
};

/// One per segment of the path.
[[nodiscard]] TANDEM_EXPORT std::vector<HermiteSegment> to_hermite_segments(const CubicPath& path);

/// The inverse of to_hermite_segments(), up to rounding of the handles.
/// closed: the last segment ends where the first one starts.
/// @throws InvalidArgument no segments, different dimensions, two segments that do not meet (equal end
/// points), a number that is not finite
[[nodiscard]] TANDEM_EXPORT CubicPath from_hermite_segments(std::span<const HermiteSegment> segments,
                                                            bool closed = false);

}  // namespace v0
}  // namespace tandem
