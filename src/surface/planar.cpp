#include "surface/planar.h"

namespace tandem {
inline namespace v0 {
namespace detail {

std::optional<PlaneAxes> common_plane(std::span<const Points* const> clouds) {
  if (clouds.front()->dim() == 2) return PlaneAxes{0, 1};
  if (clouds.front()->dim() != 3) return std::nullopt;
  // z first: that is how most planar things in R^3 lie.
  for (const std::size_t across : {2U, 1U, 0U}) {
    const double level = clouds.front()->front()[across];
    bool same = true;
    for (const Points* cloud : clouds) {
      for (std::size_t i = 0; i < cloud->size() && same; ++i) same = (*cloud)[i][across] == level;
    }
    if (same) return PlaneAxes{(across + 1) % 3, (across + 2) % 3};
  }
  return std::nullopt;
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
