#pragma once

#include <optional>
#include <span>

#include "tandem/curve/curve.h"
#include "tandem/curve/points.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A plane in R^n with a frame of two orthonormal axes.
struct Plane {
  Point origin;
  Point x;
  Point y;
  bool is_line = false;    ///< everything lies on the line along x
  double width = 0.0;      ///< how far from that line points lie, at most; 0 in R^2
  double thickness = 0.0;  ///< and from the plane
};

/// The plane of all control points, if they lie within 1e-9 of their size of one: the tolerance within which
/// curves count as closed. In R^2 the plane itself, whatever the points.
[[nodiscard]] std::optional<Plane> common_plane(std::span<const Curve> curves);
[[nodiscard]] std::optional<Plane> common_plane(std::span<const Points* const> clouds);

/// The curve in the plane's coordinates.
[[nodiscard]] Curve in_plane(const Curve& curve, const Plane& plane);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
