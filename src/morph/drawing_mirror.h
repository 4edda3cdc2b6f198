#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// An axis about which a planar drawing of several contours is its own mirror image.
struct DrawingMirror {
  double degrees = 0.0;             ///< direction of the axis, modulo 180
  std::vector<std::size_t> images;  ///< of each contour: the one that is its mirror image, maybe itself
};

/// The axes of symmetry of a drawing, within 1 % of its size. Of one that is round all over, those of its
/// longest contour as far as find_mirrors() tells them apart.
[[nodiscard]] std::vector<DrawingMirror> find_drawing_mirrors(std::span<const CubicPath> paths);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
