#pragma once

#include <optional>
#include <string_view>

#include "io/svg_document.h"
#include "tandem/io/style.h"

/// The values of SVG's presentation properties (SVG 2, sections 13.2 to 13.5; CSS Color 4). Nothing: they are
/// not valid, and do not count then.
namespace tandem {
inline namespace v0 {

/// none, currentColor, or a colour: a name, #rgb, #rrggbb, rgb(), hsl(), and those with an opacity. Of a
/// gradient the first colour, of another paint server what is named behind it, or black.
[[nodiscard]] std::optional<Paint> parse_paint(std::string_view text, const SvgDocument& document);

/// A number or a percentage, into [0,1].
[[nodiscard]] std::optional<double> parse_opacity(std::string_view text);

[[nodiscard]] std::optional<LineCap> parse_line_cap(std::string_view text);
[[nodiscard]] std::optional<LineJoin> parse_line_join(std::string_view text);
[[nodiscard]] std::optional<double> parse_miter_limit(std::string_view text);

}  // namespace v0
}  // namespace tandem
