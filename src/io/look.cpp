#include "tandem/io/look.h"

#include <algorithm>

#include "tandem/curve/bounding_box.h"

namespace tandem {
inline namespace v0 {
namespace {

ViewBox view_box_of(const Drawing& drawing) {
  if (drawing.view_box) return *drawing.view_box;
  const Box box = bounding_box(drawing.shape);
  return {box.lo[0], box.lo[1], box.hi[0] - box.lo[0], box.hi[1] - box.lo[1]};
}

ViewBox joined(const ViewBox& a, const ViewBox& b) {
  if (a == b) return a;
  const double x = std::min(a.x, b.x);
  const double y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

}  // namespace

Look look_of(std::span<const Drawing> keys) {
  Look look;
  const auto first = std::find_if(keys.begin(), keys.end(), [](const Drawing& key) { return key.style; });
  if (first != keys.end()) {
    Style style = *first->style;
    for (const Drawing& key : keys) {
      style = key.style.value_or(style);
      look.styles.push_back(style);
    }
  }
  const auto has_box = [](const Drawing& key) { return key.view_box.has_value(); };
  if (std::none_of(keys.begin(), keys.end(), has_box)) return look;
  look.view_box = view_box_of(keys.front());
  for (const Drawing& key : keys.subspan(1)) look.view_box = joined(*look.view_box, view_box_of(key));
  return look;
}

}  // namespace v0
}  // namespace tandem
