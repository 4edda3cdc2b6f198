#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tandem/io/style.h"
#include "tandem/shape/shape.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// A shape as its file draws it.
struct Drawing {
  Shape shape;
  /// Nothing: the file does not say (path data, JSON, fonts), or draws nothing that can be seen.
  std::optional<Style> style;
  std::optional<ViewBox> view_box;
  /// Its elements are drawn in several ways; `style` is the way in which the largest area is drawn.
  bool several_styles = false;
  /// What its file asks for and is left out, in words: "<text>", "dashes". Each once, in document order.
  std::vector<std::string> missed = {};
};

/// How a morph is drawn. Without styles: closed contours dark and filled, open ones as thin dark lines.
/// Without a view box: what holds all in-betweens, with a margin.
///
/// On the way from key to key colours, opacities and the width of lines change evenly. A fill that one key
/// does not have fades in or out; a line becomes thin. Caps and joins are those of the first key that has
/// lines. Contours that are born from a point, closed ones and those whose caps are not butt, have lines
/// without width there, so that they draw no dot.
struct Look {
  std::vector<Style> styles;        ///< one per key, or none
  std::optional<ViewBox> view_box;  ///< of positive size
};

/// The look of a morph through these drawings. Those without a style take that of the one before, or else of
/// the next one. The view box holds those of all drawings, and the boxes of those that have none; it is
/// empty when none has.
[[nodiscard]] TANDEM_IO_EXPORT Look look_of(std::span<const Drawing> keys);

}  // namespace v0
}  // namespace tandem
