#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/shape/path_view.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {

/// A vertex of a flattened path: a point of the curve and its parameter, an integer at joints.
struct FlatVertex {
  double x = 0.0;
  double y = 0.0;
  double u = 0.0;
};

/// A polyline: vertices [first, last] of the flattening; of a closed path the last repeats the first.
struct FlatPath {
  std::size_t first = 0;
  std::size_t last = 0;
  bool closed = false;

  [[nodiscard]] std::size_t edge_count() const noexcept { return last - first; }
};

/// Planar paths as polylines, in units of `scale` about the centre of their box, so that nothing computed
/// with them overflows or vanishes. Keeps its memory from one use to the next.
class Flattening {
 public:
  /// tolerance: share of scale; scale: absolute, 0: the diagonal of the box of all control points.
  void assign(std::span<const PathView> paths, double tolerance, double scale);

  [[nodiscard]] const std::vector<FlatVertex>& vertices() const noexcept { return vertices_; }
  /// One per path; one that is a single point has no edges.
  [[nodiscard]] const std::vector<FlatPath>& paths() const noexcept { return paths_; }
  /// A point of the plane in the units of the vertices, and back.
  [[nodiscard]] Vec2 to_flat(double x, double y) const noexcept {
    return {(0.5 * x - half_center_.x) / half_scale_, (0.5 * y - half_center_.y) / half_scale_};
  }
  [[nodiscard]] Vec2 from_flat(Vec2 p) const noexcept {
    return {2.0 * (half_center_.x + half_scale_ * p.x), 2.0 * (half_center_.y + half_scale_ * p.y)};
  }

  /// The point of the curve itself at u, for one of the paths that were flattened.
  [[nodiscard]] Vec2 point(const PathView& path, double u) const noexcept;

 private:
  void frame(std::span<const PathView> paths, double scale);
  void flatten(const PathView& path, double tolerance);

  std::vector<FlatVertex> vertices_;
  std::vector<FlatPath> paths_;
  // Halves: the extent of coordinates near the largest number would overflow.
  Vec2 half_center_;
  double half_scale_ = 1.0;
};

}  // namespace v0
}  // namespace tandem
