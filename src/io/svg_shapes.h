#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string_view>
#include <vector>

#include "io/svg_document.h"
#include "io/svg_values.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {

/// The size of the nearest <svg> in its own user units, of which percentages are shares; unknown when the
/// document names neither a viewBox nor a size.
struct SvgViewport {
  std::optional<double> width;
  std::optional<double> height;
};

/// Which size a percentage refers to.
enum class SvgAxis { x, y, diagonal };

/// In user units; nothing when it is a percentage of an unknown size.
[[nodiscard]] std::optional<double> length_in(const SvgLength& length, SvgAxis axis,
                                              const SvgViewport& viewport);

/// A length attribute in user units; nothing when it is absent or "auto". @throws ParseError
[[nodiscard]] std::optional<double> read_length(const SvgDocument& document, const pugi::xml_node& node,
                                                const char* attribute, SvgAxis axis,
                                                const SvgViewport& viewport);

/// Whether an element of that name draws an outline of its own.
[[nodiscard]] bool is_svg_shape(std::string_view name);

/// The outline of a path or basic shape (SVG 2, chapters 9 and 10); empty when it has none.
/// fill: ends that meet are closed. @throws ParseError
[[nodiscard]] std::vector<CubicPath> read_svg_shape(const SvgDocument& document, const pugi::xml_node& node,
                                                    std::string_view name, bool fill,
                                                    const Transform& transform, const SvgViewport& viewport);

}  // namespace v0
}  // namespace tandem
