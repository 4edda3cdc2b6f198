#pragma once

#include <string>
#include <string_view>

#include "tandem/io/animation.h"
#include "tandem/io/look.h"
#include "tandem/morph/path_morph.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// What of an element a style sheet animates.
enum class CssProperty {
  d,         ///< the outline of an SVG <path>; in user units, so that it scales with its <svg>
  clip_path  ///< what is shown of any element; in CSS pixels
};

/// Whether a class can be called so: an ASCII letter, then letters, digits, - and _.
[[nodiscard]] TANDEM_IO_EXPORT bool is_css_name(std::string_view name);

struct CssOptions {
  CssProperty property = CssProperty::d;
  std::string name =
      "morph";     ///< of the class and of its @keyframes: a letter, then letters, digits, - and _
  int size = 512;  ///< clip_path: pixels of the longer side
};

/// A style sheet whose class `name` runs through the morph. `d`: without styles closed contours are filled;
/// open ones, if there are any, are stroked by the class NAME-stroke, for a second <path>; with styles all
/// contours are drawn by NAME, unless some grow from points while they are stroked: those are NAME-growing.
/// The first line of the sheet says which paths it is for. A turning frame becomes a `transform`. clip_path
/// knows no lines: what contours enclose is shown, in the colour of the fill, or else of the lines; a turn is
/// baked into frames. Who prefers reduced motion sees the last key at rest.
/// @throws InvalidArgument a duration, easing, name or size that cannot be; clip_path and an open contour,
/// which encloses nothing
[[nodiscard]] TANDEM_IO_EXPORT std::string format_css(const PathMorph& morph,
                                                      const AnimationOptions& animation = {},
                                                      const CssOptions& options = {}, const Look& look = {});

}  // namespace v0
}  // namespace tandem
