#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "tandem/shape/cubic_path.h"
#include "tandem/shape/shape.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// What a contour does to a filled picture.
enum class ContourRole {
  solid,   ///< what it encloses is filled
  hole,    ///< what it encloses is cut out of a solid
  stroke,  ///< nothing: it is open
};

/// A contour's place among the others of its drawing.
struct NestedContour {
  ContourRole role = ContourRole::solid;
  /// The innermost closed contour that it lies in.
  std::optional<std::size_t> parent;
  std::size_t depth = 0;  ///< number of closed contours that it lies in
  /// A closed contour without which the filled picture is the same: one that encloses nothing, or, under the
  /// nonzero rule, one that raises the winding number of what is filled already, or lowers it to no less
  /// than 1.
  bool changes_nothing = false;
};

/// Which contour lies in which, and what is a hole, under the fill rule; one per path.
///
/// A contour lies in a larger one (by enclosed area; of equal ones in the earlier) that winds around more
/// than half of some hundred points inside it: contours may touch each other, and slightly cross. Of contours
/// that wind round themselves the nonzero region counts. Open ones lie in none and hold none;
/// those that a fill would close, as SVG's does, have to be closed before.
/// @throws InvalidArgument a path is not planar
[[nodiscard]] TANDEM_EXPORT std::vector<NestedContour> find_nesting(std::span<const CubicPath> paths,
                                                                    FillRule fill_rule);

/// The paths with solids wound counter-clockwise (y up) and holes clockwise, each from the same start: under
/// the nonzero rule they fill what they filled under `fill_rule`, as long as no two of them cross. Contours
/// that change nothing turn with the solid that they lie in.
/// @throws InvalidArgument a path is not planar
[[nodiscard]] TANDEM_EXPORT std::vector<CubicPath> orient(std::span<const CubicPath> paths,
                                                          FillRule fill_rule);

}  // namespace v0
}  // namespace tandem
