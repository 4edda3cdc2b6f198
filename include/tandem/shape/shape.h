#pragma once

#include <span>
#include <vector>

#include "tandem/curve/bounding_box.h"
#include "tandem/curve/curve.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// Which points a set of closed contours encloses.
enum class FillRule { nonzero, evenodd };

/// A drawing: contours, open or closed, of one dimension, in the order of their source.
struct TANDEM_EXPORT Shape {
  std::vector<Curve> contours;
  FillRule fill_rule = FillRule::nonzero;

  /// Dimension of the contours; 0 without any.
  [[nodiscard]] int dim() const noexcept { return contours.empty() ? 0 : contours.front().dim(); }
  friend bool operator==(const Shape&, const Shape&) = default;
};

/// The exact curves of cubic paths.
[[nodiscard]] TANDEM_EXPORT Shape to_shape(std::span<const CubicPath> paths,
                                           FillRule fill_rule = FillRule::nonzero);

/// The box around all contours.
[[nodiscard]] TANDEM_EXPORT Box bounding_box(const Shape& shape);

}  // namespace v0
}  // namespace tandem
