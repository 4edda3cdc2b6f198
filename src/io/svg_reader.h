#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tandem/io/look.h"
#include "tandem/io/svg.h"

namespace tandem {
inline namespace v0 {

/// What an SVG document draws, and the part of the plane that it shows, as far as it says so.
struct SvgPicture {
  std::vector<SvgElement> elements;
  std::optional<ViewBox> view_box;
  std::vector<std::string> missed;  ///< as Drawing::missed
};

/// parse_svg() and parse_svg_part(), with the view box of the outermost <svg>, or of the <symbol> that is
/// drawn by itself.
[[nodiscard]] SvgPicture read_svg(std::string_view text, const std::string& source);
[[nodiscard]] SvgPicture read_svg_part(std::string_view text, const std::string& id,
                                       const std::string& source);

/// The elements as one drawing. The fill rule is evenodd when that is the rule of every element that has
/// several contours, and nonzero otherwise. The style is the one in which the largest area is painted.
[[nodiscard]] Drawing merge(const SvgPicture& picture);

}  // namespace v0
}  // namespace tandem
