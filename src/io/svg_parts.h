#pragma once

#include <span>
#include <string>
#include <vector>

#include "tandem/curve/bounding_box.h"
#include "tandem/morph/path_morph.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/shape.h"

namespace tandem {
inline namespace v0 {

/// The part of the plane that a picture shows.
struct View {
  double x = 0.0;
  double y = 0.0;
  double width = 1.0;
  double height = 1.0;

  /// The larger side: what line widths are measured against.
  [[nodiscard]] double size() const noexcept { return width > height ? width : height; }
};

/// The box with a small margin all round, never empty.
[[nodiscard]] View view_of(const Box& box);

/// Decimals that keep rounding below 1e-5 of `size`; -1 (shortest exact text) where that is no sensible
/// number.
[[nodiscard]] int decimals_for(double size);
/// `precision` where it is given (>= 0), else decimals_for(the view).
[[nodiscard]] int decimals_for(const View& view, int precision);

[[nodiscard]] std::string format_view_box(const View& view);

/// A picture is one filled path of all closed contours, and one stroked path of all open ones; either may be
/// empty.
struct PathDataParts {
  std::string filled;
  std::string stroked;
};

/// lines: as format_path_data().
[[nodiscard]] PathDataParts path_data_parts(std::span<const CubicPath> paths,
                                            std::span<const std::vector<bool>> lines, int precision);

/// Width of lines, in the units of the view.
[[nodiscard]] double stroke_width(const View& view);

/// Attributes of the filled and of the stroked path.
[[nodiscard]] std::string fill_attributes(FillRule fill_rule);
[[nodiscard]] std::string stroke_attributes(const View& view);
/// The line alone of a stroked path.
[[nodiscard]] std::string line_attributes(const View& view);

}  // namespace v0
}  // namespace tandem
