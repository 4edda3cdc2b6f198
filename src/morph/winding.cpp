#include "morph/winding.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "shape/reversed.h"
#include "shape/third.h"
#include "tandem/shape/nesting.h"

namespace tandem {
inline namespace v0 {
namespace detail {

CubicPath closed_by_line(CubicPath path) {
  if (path.is_closed()) return path;
  Points points = path.control_points();
  const std::array<double, 2> from{points.back()[0], points.back()[1]};
  const std::array<double, 2> to{points.front()[0], points.front()[1]};
  if (from == to) return CubicPath(std::move(points), true);
  points.push_back(std::array{third(from[0], to[0]), third(from[1], to[1])});
  points.push_back(std::array{third(to[0], from[0]), third(to[1], from[1])});
  points.push_back(to);
  return CubicPath(std::move(points), true);
}

std::vector<CubicPath> wound(std::vector<CubicPath> paths, FillRule fill_rule) {
  if (std::all_of(paths.begin(), paths.end(), [](const CubicPath& path) { return path.is_closed(); })) {
    return orient(paths, fill_rule);
  }
  std::vector<CubicPath> filled;
  for (const CubicPath& path : paths) filled.push_back(closed_by_line(path));
  const std::vector<NestedContour> nesting = find_nesting(filled, fill_rule);
  std::vector<bool> nested(paths.size(), false);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (!nesting[i].parent) continue;
    nested[i] = true;
    nested[*nesting[i].parent] = true;
  }
  const std::vector<CubicPath> turned = orient(filled, fill_rule);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (paths[i].is_closed()) {
      paths[i] = turned[i];
    } else if (nested[i] && turned[i] != filled[i]) {
      paths[i] = reversed(paths[i]);
    }
  }
  return paths;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
