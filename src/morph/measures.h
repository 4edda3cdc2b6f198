#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/shape/cubic_path.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Of the control points of a planar path of cubics, interleaved; open ones are closed by a line.
[[nodiscard]] double signed_area(std::span<const double> points);
/// Length of a planar path, by five Gauss points per segment: near enough to compare in-betweens.
[[nodiscard]] double path_length(std::span<const double> points);

/// The mean of the edges of a planar polygon, weighted with their lengths; its first point where it has no
/// extent.
[[nodiscard]] Vec2 center_of_edges(std::span<const double> points);

/// The joints (indices of control points; 0 for the seam of closed paths) at which both paths go on in their
/// direction.
[[nodiscard]] std::vector<std::size_t> smooth_joints(const CubicPath& a, const CubicPath& b);

/// The break of direction at a joint, 1 - cos; 0 where a handle has no length.
[[nodiscard]] double direction_break(std::span<const double> points, std::size_t joint);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
