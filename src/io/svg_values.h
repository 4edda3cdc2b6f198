#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "tandem/io/style.h"
#include "tandem/shape/transform.h"

/// The values of SVG attributes. All of these throw SyntaxError with the offset in their text.
namespace tandem {
inline namespace v0 {

/// A list of transform functions; "none" and an empty text are the identity. CSS's translateX and the like,
/// and the units px and deg, are taken too.
[[nodiscard]] Transform parse_transform(std::string_view text);

/// A length in user units, or a share of the viewport, or "auto".
struct SvgLength {
  enum class Kind { user, percent, automatic };
  double value = 0.0;
  Kind kind = Kind::user;
};

/// Units: px, pt, pc, in, cm, mm, Q (96 pixels to the inch); em and rem count 16, ex and ch 8 pixels, the
/// initial font size, since text properties are not looked at.
[[nodiscard]] SvgLength parse_length(std::string_view text);

[[nodiscard]] ViewBox parse_view_box(std::string_view text);

/// The map from a viewBox onto the rectangle (0, 0, width, height), as preserveAspectRatio has it.
[[nodiscard]] Transform fit_view_box(const ViewBox& box, double width, double height,
                                     std::string_view preserve_aspect_ratio);

/// The points of polyline and polygon.
[[nodiscard]] std::vector<Vec2> parse_point_list(std::string_view text);

}  // namespace v0
}  // namespace tandem
