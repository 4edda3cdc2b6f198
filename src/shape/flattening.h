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

/// Planar paths as polylines, in units of `scale` about the centre of their box (to a whole unit where the
/// scale is given, so that it stays where paths move a little), so that nothing computed with them overflows
/// or vanishes. Keeps its memory from one use to the next, and what it has made of paths that are the same.
class Flattening {
 public:
  /// tolerance: share of scale; scale: absolute, 0: the diagonal of the box of all control points.
  void assign(std::span<const PathView> paths, double tolerance, double scale);
  /// Whether a path, or the frame of all, was another one before the last assign().
  [[nodiscard]] bool has_changed(std::size_t path) const { return changed_[path]; }

  [[nodiscard]] const std::vector<FlatVertex>& vertices() const noexcept { return vertices_; }
  /// One per path; one that is a single point has no edges.
  [[nodiscard]] const std::vector<FlatPath>& paths() const noexcept { return paths_; }
  /// A point of the plane in the units of the vertices, and back.
  [[nodiscard]] Vec2 to_flat(double x, double y) const noexcept {
    return {(0.5 * x - frame_.half_center.x) / frame_.half_scale,
            (0.5 * y - frame_.half_center.y) / frame_.half_scale};
  }
  [[nodiscard]] Vec2 from_flat(Vec2 p) const noexcept {
    return {2.0 * (frame_.half_center.x + frame_.half_scale * p.x),
            2.0 * (frame_.half_center.y + frame_.half_scale * p.y)};
  }

  /// The point of the curve itself at u, for one of the paths that were flattened.
  [[nodiscard]] Vec2 point(const PathView& path, double u) const noexcept;

 private:
  // Halves: the extent of coordinates near the largest number would overflow.
  struct Frame {
    Vec2 half_center;
    double half_scale = 1.0;
    double tolerance = 0.0;
    friend bool operator==(const Frame&, const Frame&) = default;
  };
  [[nodiscard]] static Frame find_frame(std::span<const PathView> paths, double tolerance, double scale);
  void flatten(const PathView& path);

  std::vector<FlatVertex> vertices_;
  std::vector<FlatPath> paths_;
  std::vector<bool> changed_;
  std::vector<std::vector<double>> points_;  ///< that paths_ were made of
  Frame frame_;
  std::vector<FlatVertex> vertices_before_;
  std::vector<FlatPath> paths_before_;
};

}  // namespace v0
}  // namespace tandem
