#pragma once

#include <vector>

#include "tandem/shape/cubic_path.h"
#include "tandem/shape/shape.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The path as a fill closes it.
[[nodiscard]] CubicPath closed_by_line(CubicPath path);

/// orient(), open contours included where they lie in others, or around them: they wind as they would if they
/// were closed, so that what a fill leaves out stays out.
[[nodiscard]] std::vector<CubicPath> wound(std::vector<CubicPath> paths, FillRule fill_rule);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
