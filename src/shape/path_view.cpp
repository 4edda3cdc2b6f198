#include "tandem/shape/path_view.h"

#include <fmt/format.h>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

std::vector<PathView> view_paths(std::span<const CubicPath> paths) {
  std::vector<PathView> views;
  views.reserve(paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (paths[i].dim() != 2) {
      throw InvalidArgument(
          fmt::format("path {} has dimension {}, expected a planar one", i, paths[i].dim()));
    }
    views.push_back({paths[i].control_points().data(), paths[i].is_closed()});
  }
  return views;
}

}  // namespace v0
}  // namespace tandem
