#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/shape/cubic_path.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// A planar composite cubic that somebody else owns: what is asked thousands of times, of in-betweens that
/// are never made into a CubicPath, takes these.
struct PathView {
  /// x0, y0, x1, y1, ... of 3k + 1 control points, k >= 1, all finite: the layout of Points.
  std::span<const double> points;
  /// The last control point equals the first.
  bool closed = false;

  [[nodiscard]] std::size_t segment_count() const noexcept { return (points.size() / 2 - 1) / 3; }
};

/// One view per path, in their order; valid as long as the paths are.
/// @throws InvalidArgument a path is not planar
[[nodiscard]] TANDEM_EXPORT std::vector<PathView> view_paths(std::span<const CubicPath> paths);

}  // namespace v0
}  // namespace tandem
