#include "surface/planar.h"

#include <array>
#include <cmath>

#include "surface/plane.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Of the width of all points; what lies further from a plane may be regular in space though its shadow is
/// not.
constexpr double kFlat = 1e-9;

PlaneAxes without(std::size_t across) {
  return {(across + 1) % 3, (across + 2) % 3};
}

std::optional<PlaneAxes> tilted(std::span<const Points* const> clouds) {
  const std::optional<Plane> plane = common_plane(clouds);
  if (!plane || plane->is_line || plane->thickness > kFlat * plane->width) return std::nullopt;
  std::array<double, 3> normal{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto [y, z] = without(c);
    normal[c] = std::abs(plane->x[y] * plane->y[z] - plane->x[z] * plane->y[y]);
  }
  const std::size_t yz = normal[1] > normal[2] ? 1 : 2;
  return without(normal[0] > normal[yz] ? 0 : yz);
}

}  // namespace

std::optional<PlaneAxes> plane_axes(std::span<const Points* const> clouds) {
  if (clouds.front()->dim() == 2) return PlaneAxes{0, 1};
  if (clouds.front()->dim() != 3) return std::nullopt;
  // z first: that is how most planar things in R^3 lie.
  for (const std::size_t across : {2U, 1U, 0U}) {
    const double level = clouds.front()->front()[across];
    bool same = true;
    for (const Points* cloud : clouds) {
      for (std::size_t i = 0; i < cloud->size() && same; ++i) same = (*cloud)[i][across] == level;
    }
    if (same) return without(across);
  }
  return tilted(clouds);
}

Points in_plane(const Points& points, const PlaneAxes& axes) {
  Points result(2, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t c = 0; c < 2; ++c) result[i][c] = points[i][axes[c]];
  }
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
