#pragma once

#include <optional>
#include <pugixml.hpp>

#include "io/svg_document.h"
#include "io/svg_shapes.h"
#include "io/svg_values.h"
#include "tandem/io/look.h"

namespace tandem {
inline namespace v0 {

/// The viewport that the outermost <svg>, or a <symbol> drawn by itself, establishes. It keeps its user
/// units: an icon's coordinates stay as they are written, whatever size it is to be shown at. The box that is
/// shown: as it is written, or the size that the picture has. @throws ParseError
std::optional<ViewBox> enter_outermost_viewport(const SvgDocument& document, const pugi::xml_node& node,
                                                SvgViewport& viewport);

/// The viewport of an <svg> or <symbol> inside another one; a <use> may override its size (an empty node
/// without one). In and out: transform and viewport around it, and inside it. False: it is of no size and
/// draws nothing.
/// @throws ParseError
[[nodiscard]] bool enter_inner_viewport(const SvgDocument& document, const pugi::xml_node& node,
                                        const pugi::xml_node& use, Transform& transform,
                                        SvgViewport& viewport);

}  // namespace v0
}  // namespace tandem
