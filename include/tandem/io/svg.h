#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tandem/io/animation.h"
#include "tandem/io/look.h"
#include "tandem/morph/path_morph.h"
#include "tandem/shape/shape.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// One drawable of an SVG document (path, rect, circle, ellipse, line, polyline, polygon), transforms
/// applied.
struct SvgElement {
  std::string id;  ///< empty without one
  Shape shape;
  /// With what it inherits; nothing when it is neither filled nor stroked.
  std::optional<Style> style;
};

/// All drawables in document order. Nested groups, `transform`, nested <svg> and `viewBox`, <use> of them,
/// `fill-rule` and `fill="none"` (attribute, style or style sheet) are honoured; what is not drawn (defs,
/// symbol, clipPath, mask, marker, pattern; display none, visibility hidden) is left out unless used, and so
/// is what has neither fill nor stroke beside something that has. Outlines are whole: clipping, masks, dashes
/// and markers do not count; stroked ones whose ends meet within 1e-3 of their diagonal are closed.
/// Coordinates are the user units of the outermost <svg>: its width, height and preserveAspectRatio are not
/// applied. Percentages need its viewBox, or a width and height.
/// @throws ParseError malformed XML or attribute, or no drawable at all
[[nodiscard]] TANDEM_IO_EXPORT std::vector<SvgElement> parse_svg(std::string_view text,
                                                                 const std::string& source = "svg");

/// The drawables inside the element with that id (itself, if it is one). An element that is not drawn where
/// it stands, such as a <symbol>, is drawn as <use> would draw it, in its own user units.
/// @throws ParseError as parse_svg; there is no such element
[[nodiscard]] TANDEM_IO_EXPORT std::vector<SvgElement> parse_svg_part(std::string_view text,
                                                                      const std::string& id,
                                                                      const std::string& source = "svg");

/// A still picture of the shape's contours (planar), filled or stroked.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_svg(const Shape& shape);

/// An animated SVG (SMIL `animate` of `d`) that runs through the morph. Closed contours are filled, open ones
/// stroked, unless `look` says otherwise. Who prefers reduced motion sees the last key at rest.
/// @throws InvalidArgument duration <= 0, or no such easing; another number of styles than of keys
[[nodiscard]] TANDEM_IO_EXPORT std::string format_animated_svg(const PathMorph& morph,
                                                               const AnimationOptions& options = {},
                                                               const Look& look = {});

/// One still frame; all frames with s in [0,1] have the same viewBox, beyond it grows to hold the frame.
/// precision: as AnimationOptions::precision.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_frame_svg(const PathMorph& morph, double s,
                                                            int precision = -1, const Look& look = {});

/// The keys as one <path> each, laid over each other half transparent, with the ids a to z as far as they go:
/// path data as of format_key_paths().
[[nodiscard]] TANDEM_IO_EXPORT std::string format_keys_svg(const PathMorph& morph, int precision = -1);

/// A self-contained HTML page (no network): the morph with slider, play button, film strip and onion skin.
/// Opened as page.html#s=0.5 it rests there; #s=0.5&onion shows the onion skin as well.
/// @throws InvalidArgument duration <= 0, or no such easing
[[nodiscard]] TANDEM_IO_EXPORT std::string format_html_player(const PathMorph& morph,
                                                              const std::string& title,
                                                              const AnimationOptions& options = {},
                                                              const Look& look = {});

}  // namespace v0
}  // namespace tandem
