#pragma once

#include <span>
#include <vector>

#include "surface/vector3.h"
#include "tandem/io/scene.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A scene moved into the unit ball, so that sizes need no care, and seen along parallel rays. x: to the
/// right, y: up, z: towards the viewer.
class Camera {
 public:
  /// Planar scenes from above, y down; others from above at an angle, and of four sides from that which shows
  /// clearly more than the first one.
  explicit Camera(const Scene& scene);

  [[nodiscard]] Vector3 place(std::span<const double> point) const;
  /// Of a direction.
  [[nodiscard]] Vector3 turn(std::span<const double> direction) const;
  [[nodiscard]] std::vector<Vector3> place(const Points& points) const;
  /// Where it stands, in degrees; planar scenes have y up for this.
  [[nodiscard]] double azimuth() const noexcept { return azimuth_; }
  [[nodiscard]] double elevation() const noexcept { return elevation_; }

 private:
  void look_from(double azimuth, double elevation);

  Vector3 center_{};
  double radius_ = 1.0;
  double azimuth_ = -90.0;
  double elevation_ = 90.0;
  Vector3 right_{1.0, 0.0, 0.0};
  Vector3 up_{0.0, -1.0, 0.0};
  Vector3 toward_{0.0, 0.0, 1.0};
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
