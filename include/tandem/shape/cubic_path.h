#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "tandem/curve/curve.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// A composite cubic Bezier: what SVG, fonts and Lottie speak. k segments share 3k + 1 control points.
/// A straight line is the cubic with its handles at the thirds.
class TANDEM_EXPORT CubicPath {
 public:
  /// control_points: dim x (3k + 1), k >= 1, all finite; closed: the last point must equal the first.
  /// @throws InvalidArgument otherwise
  explicit CubicPath(Points control_points, bool closed = false);

  [[nodiscard]] int dim() const noexcept { return control_points_.dim(); }
  [[nodiscard]] std::size_t segment_count() const noexcept { return (control_points_.size() - 1) / 3; }
  [[nodiscard]] const Points& control_points() const noexcept { return control_points_; }
  [[nodiscard]] bool is_closed() const noexcept { return closed_; }
  /// The four control points of segment i.
  [[nodiscard]] std::array<std::span<const double>, 4> segment(std::size_t i) const noexcept;
  /// Segment i is a line run through at constant speed: its handles stand at the thirds within `tolerance`
  /// (absolute, in each coordinate).
  [[nodiscard]] bool is_line(std::size_t i, double tolerance) const;

  friend bool operator==(const CubicPath&, const CubicPath&) = default;

 private:
  Points control_points_;
  bool closed_ = false;
};

/// The path as a B-spline of degree 3 over [0, k] with triple knots at the joints; exact. Joints that are C1
/// or smoother keep their triple knot: the parameter is the path's own (segment i over [i, i + 1]).
[[nodiscard]] TANDEM_EXPORT Curve to_curve(const CubicPath& path);

/// The curve as cubics: exact for polynomial curves of degree <= 3, otherwise within `tolerance` (absolute,
/// > 0), by Hermite interpolation of each span, halved as often as needed. Breaks stand at the knots.
[[nodiscard]] TANDEM_EXPORT CubicPath to_cubic_path(const Curve& curve, double tolerance);

}  // namespace v0
}  // namespace tandem
