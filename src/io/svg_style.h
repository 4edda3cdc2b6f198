#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/svg_document.h"
#include "io/svg_values.h"
#include "tandem/io/style.h"
#include "tandem/shape/shape.h"

namespace tandem {
inline namespace v0 {

/// The properties that decide what is drawn, where, and how; those from stroke_dasharray on are not drawn,
/// only missed.
enum class SvgProperty {
  fill,
  stroke,
  fill_rule,
  display,
  visibility,
  transform,
  color,
  opacity,
  fill_opacity,
  stroke_opacity,
  stroke_width,
  stroke_linecap,
  stroke_linejoin,
  stroke_miterlimit,
  stroke_dasharray,
  clip_path,
  mask,
  filter,
  marker_start,
  marker_mid,
  marker_end
};
inline constexpr std::size_t kSvgProperties = 21;

/// A value and how strongly it is meant: the cascade keeps the strongest, and the later one of equals.
struct Declaration {
  std::string_view value;
  int strength = -1;
  unsigned order = 0;

  void weigh(const Declaration& other) {
    if (other.strength > strength || (other.strength == strength && other.order >= order)) *this = other;
  }
};

using Declarations = std::array<std::optional<Declaration>, kSvgProperties>;

/// The <style> elements of a document, as far as one can go without a CSS engine: rules whose selectors are
/// an element name, a class or an id, or a name with one of these. Others, and whatever stands inside
/// @-rules, do not apply.
class StyleSheet {
 public:
  explicit StyleSheet(const SvgDocument& document);

  /// What applies to an element: attributes, then rules, then its own style attribute.
  [[nodiscard]] Declarations cascade(const pugi::xml_node& node, std::string_view name) const;

  /// The first selector that is not understood, and could apply to a picture at rest; empty without one.
  [[nodiscard]] const std::string& unread_selector() const noexcept { return unread_selector_; }

 private:
  void read(std::string_view css);
  void add_rules(std::string_view selectors, std::string_view body);
  void apply(const std::string& key, Declarations& into) const;

  std::string css_;  ///< all style elements, without comments; the declarations point into it
  std::string unread_selector_;
  unsigned order_ = 0;
  std::unordered_map<std::string, Declarations> rules_;
};

/// What an element asks for and is not drawn with, in words: "dashes", "a mask".
[[nodiscard]] std::vector<std::string_view> missed_by(const Declarations& own);

/// What an element has from its ancestors and its own declarations.
struct SvgStyle {
  Style style;  ///< without the opacities below, and the width of lines
  SvgLength stroke_width{1.0, SvgLength::Kind::user};
  Paint color{Paint::Kind::current, {}, 1.0};  ///< what currentColor means
  double opacity = 1.0;                        ///< of all elements around, multiplied
  double fill_opacity = 1.0;
  double stroke_opacity = 1.0;
  bool visible = true;
  FillRule fill_rule = FillRule::nonzero;

  /// Values that are not valid do not count.
  void inherit(const Declarations& own, const SvgDocument& document);
  /// With everything applied. width: of lines, in the units of the drawing.
  [[nodiscard]] Style resolved(double width) const;
};

}  // namespace v0
}  // namespace tandem
