#pragma once

#include <optional>
#include <vector>

#include "tandem/shape/cubic_path.h"
#include "tandem/shape/transform.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// Collects planar drawing commands into cubic paths: what path data, basic shapes and glyph outlines share.
///
/// Lines, quadratics and cubics are exact; circular and elliptic arcs become cubics of at most 45 degrees
/// each (within 5e-6 of the radius). Segments of no length at all (all four control points equal) are
/// dropped, and subpaths left with none of them vanish.
class TANDEM_EXPORT PathBuilder {
 public:
  /// Everything drawn afterwards goes through `transform`.
  void set_transform(const Transform& transform);

  /// Ends the subpath before it, open; what is drawn next starts at p.
  void move_to(Vec2 p);
  /// All drawing commands need a current point. @throws InvalidArgument there is none
  void line_to(Vec2 p);
  void quad_to(Vec2 control, Vec2 p);
  void cubic_to(Vec2 control1, Vec2 control2, Vec2 p);
  /// SVG elliptical arc (SVG 2, 9.5.1 and appendix B.2): out-of-range radii are corrected as it says there.
  void arc_to(Vec2 radii, double x_axis_rotation_degrees, bool large_arc, bool sweep, Vec2 p);
  /// Closes the subpath, by a line when its ends are further apart than 1e-9 of its extent; nearer ones are
  /// made to meet. The next command starts at the subpath's first point.
  void close();

  /// Current point in the coordinates of the caller (before the transform).
  [[nodiscard]] Vec2 current() const noexcept { return current_; }
  [[nodiscard]] bool has_current() const noexcept { return has_current_; }

  /// Ends the last subpath and hands over all of them.
  /// @throws InvalidArgument a coordinate is not finite (here, or when a later command ends that subpath)
  [[nodiscard]] std::vector<CubicPath> take();

 private:
  void start_if_needed();
  void append(Vec2 c1, Vec2 c2, Vec2 p);
  void finish(bool closed);

  Transform transform_;
  std::vector<CubicPath> paths_;
  Points points_;
  Vec2 start_{};
  Vec2 current_{};
  bool has_current_ = false;
};

}  // namespace v0
}  // namespace tandem
