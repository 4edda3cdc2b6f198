#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "tandem/curve/points.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Which two coordinates of points in R^2 or R^3 matter when they lie in a plane across an axis.
using PlaneAxes = std::array<std::size_t, 2>;

/// The plane in which all the points lie, exactly: one of their three coordinates is the same number
/// throughout. The axes are in the order that keeps the normal pointing along the third. None: not planar.
[[nodiscard]] std::optional<PlaneAxes> common_plane(std::span<const Points* const> clouds);

/// The two coordinates, in R^2.
[[nodiscard]] Points in_plane(const Points& points, const PlaneAxes& axes);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
