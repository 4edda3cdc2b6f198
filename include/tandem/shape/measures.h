#pragma once

#include <cstddef>
#include <vector>

#include "tandem/shape/cubic_path.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// What a planar path encloses, counter-clockwise (y up) positive: the integral of the winding number. Exact
/// to rounding, by Green's theorem; an open path is closed by a line. Its length is that of to_curve(path)
/// (arc_length.h). @throws InvalidArgument the path is not planar
[[nodiscard]] TANDEM_EXPORT double signed_area(const CubicPath& path);

/// How far a path turns on the spot at its joints, in radians, in [0, pi]: 0 where it is smooth (G1).
///
/// One per joint: joint i lies between segments i - 1 and i; joint 0 of a closed path between the last and
/// the first. Ends of an open path, and paths of no extent, have 0. A handle of no length takes its direction
/// from the next control point that differs, across segments of no length too.
/// @throws InvalidArgument the path is not planar
[[nodiscard]] TANDEM_EXPORT std::vector<double> tangent_breaks(const CubicPath& path);

}  // namespace v0
}  // namespace tandem
