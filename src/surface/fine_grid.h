#pragma once

#include <cstddef>
#include <vector>

#include "surface/grid_cell.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Parameters of the lines of a grid, increasing, from one end of the domain to the other.
struct ParameterGrid {
  std::vector<double> u;
  std::vector<double> v;
};

/// A grid through all knots whose cells, cut as split_cell() does, are nowhere further from the surface than
/// `chord`, in units of its extent, and whose triangles differ from it by no more than `angle` (radians) at
/// their corners; see TessellateOptions. @throws InvalidArgument more than 2^22 vertices would be needed
[[nodiscard]] ParameterGrid fine_grid(const ScaledSurface& surface, double chord, double angle);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
