#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "surface/bernstein_grid.h"
#include "surface/enclosed_spline.h"
#include "tandem/surface/surface.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Part of a domain, u first.
using Cell = std::array<Interval, 2>;

/// A surface with enclosed coefficients, in the plane or in space, and what its regularity depends on.
class EnclosedSurface {
 public:
  /// Rational ones carry their weights; one that is closed along u is closed exactly (EnclosedSpline::weld)
  /// if it is planar.
  explicit EnclosedSurface(const Surface& surface);

  [[nodiscard]] std::size_t dim() const noexcept { return dim_; }
  [[nodiscard]] bool is_rational() const noexcept { return rational_; }
  /// The distinct knots along u and v.
  [[nodiscard]] const std::array<std::vector<double>, 2>& breaks() const noexcept { return breaks_; }

  /// S_u x S_v over a cell within one span of either parameter, up to a positive factor: its third coordinate
  /// (planar) or all three, as polynomials. An edge of the surface that is one point is divided out.
  [[nodiscard]] std::vector<BernsteinGrid> normal(const Cell& cell) const;

  /// S_u (`along` = 0) or S_v (1) of a surface in space over such a cell, up to a positive factor: its three
  /// coordinates.
  [[nodiscard]] std::vector<BernsteinGrid> tangent(std::size_t along, const Cell& cell) const;

  /// Whether an edge is one point, exactly: of u (0) or v (1) fixed, at the start or the end.
  [[nodiscard]] bool is_pole(std::size_t along, bool at_end) const noexcept {
    return poles_[along][at_end ? 1 : 0];
  }
  /// The edge v = start or end as a spline over u (`along` = 0), or u = start or end over v (1).
  [[nodiscard]] EnclosedSpline edge(std::size_t along, bool at_end) const;

 private:
  /// Homogeneous coordinates over a cell, or those of a derivative (by u: 1, 0).
  [[nodiscard]] std::vector<BernsteinGrid> patch(const Cell& cell, bool by_u, bool by_v) const;

  std::size_t dim_;
  bool rational_;
  std::size_t group_;  // numbers of a point
  std::array<int, 2> degree_;
  std::array<std::vector<double>, 2> knots_;
  EnclosedSpline along_u_;  // its coefficients are whole lines along v
  std::array<std::vector<double>, 2> breaks_;
  std::array<std::array<bool, 2>, 2> poles_{};
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
