#include "io/svg_style.h"

#include <algorithm>

#include "io/svg_paint.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr std::array<std::string_view, kSvgProperties> kNames = {
    "fill",         "stroke",         "fill-rule",       "display",           "visibility",
    "transform",    "color",          "opacity",         "fill-opacity",      "stroke-opacity",
    "stroke-width", "stroke-linecap", "stroke-linejoin", "stroke-miterlimit", "stroke-dasharray",
    "clip-path",    "mask",           "filter",          "marker-start",      "marker-mid",
    "marker-end"};

struct Missed {
  SvgProperty property;
  std::string_view words;
};
constexpr std::array<Missed, 7> kMissed = {{{SvgProperty::stroke_dasharray, "dashes"},
                                            {SvgProperty::clip_path, "a clip path"},
                                            {SvgProperty::mask, "a mask"},
                                            {SvgProperty::filter, "a filter"},
                                            {SvgProperty::marker_start, "markers"},
                                            {SvgProperty::marker_mid, "markers"},
                                            {SvgProperty::marker_end, "markers"}}};

// Strengths of the cascade (CSS Cascading and Inheritance 4, section 6): presentation attributes give way to
// every rule; among rules ids beat classes beat names; the style attribute beats rules; !important beats all
// that is not.
constexpr int kAttribute = 0;
constexpr int kUniversalRule = 1;
constexpr int kNameRule = 2;
constexpr int kClassRule = 10;
constexpr int kIdRule = 100;
constexpr int kStyleAttribute = 1000;
constexpr int kImportant = 10000;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool equals_ignoring_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

/// Calls f with every part of `text` between separators, none of which stands inside brackets.
template <typename Function>
void for_each_part(std::string_view text, char separator, Function f) {
  std::size_t start = 0;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') depth = std::max(depth - 1, 0);
    if (text[i] != separator || depth > 0) continue;
    f(trimmed(text.substr(start, i - start)));
    start = i + 1;
  }
  f(trimmed(text.substr(start)));
}

void weigh(std::optional<Declaration>& place, const Declaration& declaration) {
  if (!place) place.emplace();
  place->weigh(declaration);
}

/// "fill: none; stroke: red !important"
void read_declarations(std::string_view body, int strength, unsigned order, Declarations& into) {
  for_each_part(body, ';', [&](std::string_view declaration) {
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos) return;
    const std::string_view property = trimmed(declaration.substr(0, colon));
    for (std::size_t k = 0; k < kSvgProperties; ++k) {
      if (!equals_ignoring_case(property, kNames[k])) continue;
      std::string_view value = trimmed(declaration.substr(colon + 1));
      const std::size_t mark = value.rfind('!');
      const bool important = mark != std::string_view::npos &&
                             equals_ignoring_case(trimmed(value.substr(mark + 1)), "important");
      if (important) value = trimmed(value.substr(0, mark));
      weigh(into[k], {value, strength + (important ? kImportant : 0), order});
    }
  });
}

std::string without_comments(std::string_view css) {
  std::string result;
  for (;;) {
    const std::size_t start = css.find("/*");
    result += css.substr(0, start);
    if (start == std::string_view::npos) return result;
    const std::size_t end = css.find("*/", start + 2);
    if (end == std::string_view::npos) return result;
    result += ' ';
    css.remove_prefix(end + 2);
  }
}

bool is_name(std::string_view text) {
  return !text.empty() && std::none_of(text.begin(), text.end(), [](char c) {
    return is_blank(c) || std::string_view(".#*:>+~[](){}\"'").find(c) != std::string_view::npos;
  });
}

/// The strength of a selector that is understood, -1 for others.
int selector_strength(std::string_view selector) {
  if (selector == "*") return kUniversalRule;
  const std::size_t mark = selector.find_first_of(".#");
  if (mark == std::string_view::npos) return is_name(selector) ? kNameRule : -1;
  const std::string_view name = selector.substr(0, mark);
  if ((!name.empty() && !is_name(name)) || !is_name(selector.substr(mark + 1))) return -1;
  return (selector[mark] == '#' ? kIdRule : kClassRule) + (name.empty() ? 0 : kNameRule);
}

/// The end of the block that starts at '{', behind its '}'.
std::size_t end_of_block(std::string_view css, std::size_t start) {
  int depth = 0;
  for (std::size_t i = start; i < css.size(); ++i) {
    if (css[i] == '{') ++depth;
    if (css[i] == '}' && --depth == 0) return i + 1;
  }
  return css.size();
}

std::optional<SvgLength> parse_stroke_width(std::string_view text) {
  try {
    const SvgLength length = parse_length(text);
    if (length.kind != SvgLength::Kind::automatic && length.value >= 0.0) return length;
  } catch (const SyntaxError&) {
    return std::nullopt;
  }
  return std::nullopt;
}

/// The paint as it comes out, nothing where it cannot be seen.
Paint resolved_paint(const Paint& paint, const Paint& color, double opacity) {
  Paint result = paint;
  if (paint.kind == Paint::Kind::current) result = color;
  result.opacity *= opacity;
  return result.opacity > 0.0 ? result : Paint{};
}

}  // namespace

StyleSheet::StyleSheet(const SvgDocument& document) {
  for (const pugi::xml_node& style : document.style_elements()) {
    for (const pugi::xml_node& text : style.children()) {
      css_ += without_comments(text.value());
      css_ += '\n';
    }
  }
  read(css_);
}

void StyleSheet::read(std::string_view css) {
  while (!(css = trimmed(css)).empty()) {
    if (css.front() == '@') {
      const std::size_t mark = std::min(css.find_first_of(";{"), css.size());
      const bool block = mark < css.size() && css[mark] == '{';
      css.remove_prefix(block ? end_of_block(css, mark) : std::min(mark + 1, css.size()));
      continue;
    }
    const std::size_t open = css.find('{');
    if (open == std::string_view::npos) return;
    const std::size_t end = end_of_block(css, open);
    add_rules(css.substr(0, open), css.substr(open + 1, end - open - 2));
    css.remove_prefix(end);
  }
}

void StyleSheet::add_rules(std::string_view selectors, std::string_view body) {
  ++order_;
  Declarations declarations;
  read_declarations(body, 0, order_, declarations);
  for_each_part(selectors, ',', [&](std::string_view selector) {
    const int strength = selector_strength(selector);
    if (strength < 0) {
      // :hover and its like say nothing of a picture at rest.
      if (unread_selector_.empty() && selector.find(':') == std::string_view::npos)
        unread_selector_ = selector;
      return;
    }
    Declarations& rule = rules_[std::string(selector)];
    for (std::size_t k = 0; k < kSvgProperties; ++k) {
      if (!declarations[k]) continue;
      Declaration declaration = *declarations[k];
      declaration.strength += strength;
      weigh(rule[k], declaration);
    }
  });
}

void StyleSheet::apply(const std::string& key, Declarations& into) const {
  const auto found = rules_.find(key);
  if (found == rules_.end()) return;
  for (std::size_t k = 0; k < kSvgProperties; ++k) {
    if (found->second[k]) weigh(into[k], *found->second[k]);
  }
}

Declarations StyleSheet::cascade(const pugi::xml_node& node, std::string_view name) const {
  Declarations result;
  for (std::size_t k = 0; k < kSvgProperties; ++k) {
    if (const pugi::xml_attribute attribute = node.attribute(kNames[k].data())) {
      weigh(result[k], {trimmed(attribute.value()), kAttribute, 0});
    }
  }
  if (!rules_.empty()) {
    const std::string element(name);
    apply("*", result);
    apply(element, result);
    for_each_part(node.attribute("class").value(), ' ', [&](std::string_view token) {
      if (token.empty()) return;
      apply("." + std::string(token), result);
      apply(element + "." + std::string(token), result);
    });
    const std::string id = node.attribute("id").value();
    apply("#" + id, result);
    apply(element + "#" + id, result);
  }
  read_declarations(node.attribute("style").value(), kStyleAttribute, 0, result);
  return result;
}

std::vector<std::string_view> missed_by(const Declarations& own) {
  std::vector<std::string_view> result;
  for (const Missed& missed : kMissed) {
    const auto& declaration = own[static_cast<std::size_t>(missed.property)];
    if (!declaration || declaration->value.empty()) continue;
    const bool none = equals_ignoring_case(declaration->value, "none") ||
                      equals_ignoring_case(declaration->value, "inherit");
    if (!none) result.push_back(missed.words);
  }
  for (const auto& declaration : own) {
    if (declaration && declaration->value.substr(0, 4) == "var(") result.emplace_back("values by var()");
  }
  for (const SvgProperty property : {SvgProperty::fill, SvgProperty::stroke}) {
    const auto& declaration = own[static_cast<std::size_t>(property)];
    if (declaration && declaration->value.substr(0, 4) == "url(") {
      result.emplace_back("gradients and patterns beyond their first colour");
    }
  }
  return result;
}

void SvgStyle::inherit(const Declarations& own, const SvgDocument& document) {
  const auto read = [&own](SvgProperty property, auto parse, auto& into) {
    const auto& declaration = own[static_cast<std::size_t>(property)];
    if (!declaration || equals_ignoring_case(declaration->value, "inherit")) return;
    if (const auto value = parse(declaration->value)) into = *value;
  };
  const auto paint = [&document](std::string_view text) { return parse_paint(text, document); };
  read(SvgProperty::fill, paint, style.fill);
  read(SvgProperty::stroke, paint, style.stroke);
  read(SvgProperty::fill_opacity, parse_opacity, fill_opacity);
  read(SvgProperty::stroke_opacity, parse_opacity, stroke_opacity);
  read(SvgProperty::stroke_linecap, parse_line_cap, style.line_cap);
  read(SvgProperty::stroke_linejoin, parse_line_join, style.line_join);
  read(SvgProperty::stroke_miterlimit, parse_miter_limit, style.miter_limit);
  read(SvgProperty::stroke_width, parse_stroke_width, stroke_width);
  Paint own_color = color;
  read(SvgProperty::color, paint, own_color);
  if (own_color.kind != Paint::Kind::current) color = own_color;
  double own_opacity = 1.0;
  read(SvgProperty::opacity, parse_opacity, own_opacity);
  opacity *= own_opacity;
  read(
      SvgProperty::fill_rule,
      [](std::string_view text) -> std::optional<FillRule> {
        return equals_ignoring_case(text, "evenodd") ? FillRule::evenodd : FillRule::nonzero;
      },
      fill_rule);
  read(
      SvgProperty::visibility,
      [](std::string_view text) -> std::optional<bool> { return equals_ignoring_case(text, "visible"); },
      visible);
}

Style SvgStyle::resolved(double width) const {
  Style result = style;
  result.fill = resolved_paint(style.fill, color, opacity * fill_opacity);
  result.stroke = width > 0.0 ? resolved_paint(style.stroke, color, opacity * stroke_opacity) : Paint{};
  result.stroke_width = width;
  return result;
}

}  // namespace v0
}  // namespace tandem
