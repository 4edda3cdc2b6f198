#pragma once

#include <span>

#include "tandem/morph/path_morph.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The frame of a planar blend between two keys: MovingFrame in the plane, which may grow as well. It turns
/// by `degrees` and grows by `scale` evenly on the way, while its origin moves straight from one centre to
/// the other.
class PlanarFrame {
 public:
  /// Stands still, about (0, 0).
  PlanarFrame() = default;
  PlanarFrame(Vec2 first_center, Vec2 second_center, double degrees, double scale);

  [[nodiscard]] Vec2 first_center() const noexcept { return first_center_; }
  [[nodiscard]] Vec2 second_center() const noexcept { return second_center_; }
  [[nodiscard]] double degrees() const noexcept { return degrees_; }
  [[nodiscard]] double scale() const noexcept { return scale_; }
  [[nodiscard]] bool stands_still() const noexcept { return degrees_ == 0.0 && scale_ == 1.0; }

  /// The second key's path as the frame sees it: where the first key's lies.
  [[nodiscard]] CubicPath from_second(const CubicPath& path) const;
  /// Points seen in the frame, where they are at s.
  void place(double s, std::span<double> points) const;
  /// What place() does to a point.
  [[nodiscard]] Transform placement(double s) const;

 private:
  Vec2 first_center_{};
  Vec2 second_center_{};
  double degrees_ = 0.0;
  double scale_ = 1.0;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
