#include "tandem/shape/shape.h"

namespace tandem {
inline namespace v0 {

Shape to_shape(std::span<const CubicPath> paths, FillRule fill_rule) {
  Shape shape;
  shape.fill_rule = fill_rule;
  shape.contours.reserve(paths.size());
  for (const CubicPath& path : paths) shape.contours.push_back(to_curve(path));
  return shape;
}

Box bounding_box(const Shape& shape) {
  Box box;
  for (const Curve& contour : shape.contours) box.include(bounding_box(contour));
  return box;
}

}  // namespace v0
}  // namespace tandem
