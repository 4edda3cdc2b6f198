#pragma once

#include <cstddef>
#include <utility>

#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {

/// The path from its end to its start.
[[nodiscard]] inline CubicPath reversed(const CubicPath& path) {
  Points points;
  for (std::size_t i = path.control_points().size(); i-- > 0;) points.push_back(path.control_points()[i]);
  return CubicPath(std::move(points), path.is_closed());
}

}  // namespace v0
}  // namespace tandem
