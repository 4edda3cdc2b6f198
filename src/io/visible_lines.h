#pragma once

#include <array>
#include <span>
#include <vector>

#include "io/faces.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A polyline in pixels, x to the right, y down.
using PixelLine = std::vector<std::array<double, 2>>;

/// The parts of lines that no face hides, without the points that change nothing. slack: how much deeper than
/// a face a point may lie, in the camera's units; at least what the triangles are off.
[[nodiscard]] std::vector<PixelLine> visible_parts(std::span<const Points> lines, const Camera& camera,
                                                   const Faces& faces, double slack);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
