#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "tandem/curve/points.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The two coordinates by which points in R^2, or in a plane of R^3, are told apart.
using PlaneAxes = std::array<std::size_t, 2>;

/// Those of points that all lie in one plane: across an axis, exactly, or within 1e-9 of their width of any
/// other, of which the shadow along the axis nearest to its normal is taken. That leaves coordinates as they
/// are, and of a plane it is one-to-one. In the order that keeps the normal pointing along the third axis.
/// None: not planar.
[[nodiscard]] std::optional<PlaneAxes> plane_axes(std::span<const Points* const> clouds);

/// The two coordinates, in R^2.
[[nodiscard]] Points in_plane(const Points& points, const PlaneAxes& axes);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
