#include "io/scene_ball.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "curve/norm.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {

SceneBall ball_of(const Scene& scene) {
  Vector3 lo;
  Vector3 hi;
  lo.fill(std::numeric_limits<double>::infinity());
  hi.fill(-std::numeric_limits<double>::infinity());
  const auto add = [&](const Points& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        lo[k] = std::min(lo[k], points[i][k]);
        hi[k] = std::max(hi[k], points[i][k]);
      }
    }
  };
  add(scene.mesh.vertices);
  for_each_line(scene, add);
  SceneBall ball;
  if (!(lo[0] <= hi[0])) return ball;
  Vector3 half{};
  for (std::size_t k = 0; k < 3; ++k) {
    ball.center[k] = lo[k] / 2.0 + hi[k] / 2.0;
    half[k] = hi[k] / 2.0 - lo[k] / 2.0;
  }
  const double radius = scaled_norm(half);
  if (radius > 0.0) ball.radius = radius;
  return ball;
}

void check_scene(const Scene& scene) {
  if (scene.mesh.triangles.empty()) {
    throw InvalidArgument("the surface has no area, there is nothing to draw");
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
