#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "surface/vector3.h"
#include "tandem/surface/surface.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A surface of R^2 or R^3 seen in units of its extent, so that distances may be squared; planar ones lie in
/// z = 0.
class ScaledSurface {
 public:
  /// Looks at `surface`, which must outlive it.
  explicit ScaledSurface(const Surface& surface);

  [[nodiscard]] const Surface& surface() const noexcept { return surface_; }
  [[nodiscard]] Vector3 point(double u, double v) const;
  /// A point of the surface, or a control point.
  [[nodiscard]] Vector3 scaled(std::span<const double> point) const;
  /// Unit, or zero where the surface has none.
  [[nodiscard]] Vector3 normal(double u, double v, SurfaceSides sides) const;

 private:
  const Surface& surface_;
  std::array<double, 3> origin_{};
};

/// Corners of a cell, or indices of its vertices: (u0, v0), (u1, v0), (u1, v1), (u0, v1).
template <class T>
using CellCorners = std::array<T, 4>;

/// The two triangles of a cell as indices of its corners, counter-clockwise.
using CellTriangles = std::array<std::array<std::size_t, 3>, 2>;

/// Cut along the diagonal that lies nearer to the cell's middle; of the two that are as near, along the
/// shorter one. normal: of the surface in the cell; triangles that look the other way are avoided.
[[nodiscard]] CellTriangles split_cell(const CellCorners<Vector3>& corners, const Vector3& middle,
                                       const Vector3& normal);

/// Of p from a triangle.
[[nodiscard]] double distance_to_triangle(const Vector3& p, const std::array<Vector3, 3>& triangle);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
