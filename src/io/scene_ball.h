#pragma once

#include "surface/vector3.h"
#include "tandem/io/scene.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Holds all of a scene.
struct SceneBall {
  Vector3 center{};
  double radius = 1.0;  ///< half the diagonal of the box; 1 for a single point
};
[[nodiscard]] SceneBall ball_of(const Scene& scene);

/// Calls f(line) for all lines of a scene.
template <class F>
void for_each_line(const Scene& scene, F f) {
  for (const std::vector<Points>* lines : {&scene.iso_lines, &scene.edges, &scene.curves}) {
    for (const Points& line : *lines) f(line);
  }
}

/// @throws InvalidArgument there is no triangle to be seen
void check_scene(const Scene& scene);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
