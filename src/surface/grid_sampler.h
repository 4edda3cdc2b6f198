#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "surface/grid_cell.h"
#include "surface/vector3.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Points of a surface at grids of parameters, in the units of ScaledSurface: what many points have in common
/// is computed once.
class GridSampler {
 public:
  /// Looks at the surface, which must outlive it.
  explicit GridSampler(const ScaledSurface& surface);

  /// The parameters u of all grids from now on.
  void set_rows(std::span<const double> u);
  /// And the parameters v.
  void set_columns(std::span<const double> v);

  /// At row i and column j.
  [[nodiscard]] Vector3 at(std::size_t i, std::size_t j) const;

 private:
  const Surface& surface_;
  std::size_t stride_;           ///< numbers per control point: coordinates, times the weight, and the weight
  std::vector<double> control_;  ///< the surface's control points
  std::vector<double> lines_;    ///< control points of the lines u = const, one after the other
  std::vector<std::size_t> first_;  ///< of each column: the first control point of its span
  std::vector<double> basis_;       ///< of each column
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
