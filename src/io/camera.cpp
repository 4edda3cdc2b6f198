#include "io/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "io/scene_ball.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Degrees. Neither along an axis nor halfway between two, so that no two axes fall together.
constexpr double kAzimuth = -58.0;
constexpr double kElevation = 28.0;
// What another side must show more than the first one to be preferred.
constexpr double kClearlyMore = 1.25;

}  // namespace

Camera::Camera(const Scene& scene) {
  const SceneBall ball = ball_of(scene);
  center_ = ball.center;
  radius_ = ball.radius;
  if (scene.planar) return;
  std::array<double, 4> shown{};
  std::size_t best = 0;
  for (std::size_t side = 0; side < shown.size(); ++side) {
    look_from(kAzimuth + 90.0 * static_cast<double>(side), kElevation);
    const std::vector<Vector3> points = place(scene.mesh.vertices);
    for (const auto& t : scene.mesh.triangles) {
      shown[side] += std::fabs(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])[2]);
    }
    if (shown[side] > (best == 0 ? kClearlyMore : 1.0) * shown[best]) best = side;
  }
  look_from(kAzimuth + 90.0 * static_cast<double>(best), kElevation);
}

void Camera::look_from(double azimuth, double elevation) {
  azimuth_ = azimuth;
  elevation_ = elevation;
  constexpr double kRadians = 3.14159265358979323846 / 180.0;
  const double a = azimuth * kRadians;
  const double e = elevation * kRadians;
  toward_ = {std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e)};
  right_ = {-std::sin(a), std::cos(a), 0.0};
  up_ = cross(toward_, right_);
}

Vector3 Camera::place(std::span<const double> p) const {
  Vector3 local{};
  for (std::size_t k = 0; k < 3; ++k) local[k] = p[k] / radius_ - center_[k] / radius_;
  return turn(local);
}

Vector3 Camera::turn(std::span<const double> d) const {
  const Vector3 v = {d[0], d[1], d[2]};
  return {dot(v, right_), dot(v, up_), dot(v, toward_)};
}

std::vector<Vector3> Camera::place(const Points& points) const {
  std::vector<Vector3> result;
  result.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) result.push_back(place(points[i]));
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
