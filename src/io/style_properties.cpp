#include "io/style_properties.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "io/number.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr int kDecimals = 6;  // of opacities and limits
constexpr double kMiterLimit = 4.0;
constexpr const char* kInitialRule = "nonzero";

const char* text_of(LineCap cap) {
  return cap == LineCap::round ? "round" : cap == LineCap::square ? "square" : "butt";
}

const char* text_of(LineJoin join) {
  return join == LineJoin::round ? "round" : join == LineJoin::bevel ? "bevel" : "miter";
}

class Properties {
 public:
  explicit Properties(const std::vector<Style>& keys) : keys_(keys) {}

  template <class Value>
  void add(const char* name, Value value) {
    StyleProperty property{name, {}};
    for (const Style& key : keys_) property.values.push_back(value(key));
    all_.push_back(std::move(property));
  }
  /// Nothing says so by itself.
  void add_opacity(const char* name, Paint Style::*paint) {
    if (std::all_of(keys_.begin(), keys_.end(),
                    [&](const Style& key) { return (key.*paint).opacity == 1.0; }))
      return;
    add(name, [&](const Style& key) { return format_number((key.*paint).opacity, kDecimals); });
  }
  [[nodiscard]] std::vector<StyleProperty> take() { return std::move(all_); }

 private:
  const std::vector<Style>& keys_;
  std::vector<StyleProperty> all_;
};

}  // namespace

bool StyleProperty::changes() const {
  return std::any_of(values.begin(), values.end(),
                     [this](const std::string& value) { return value != values.front(); });
}

std::vector<StyleProperty> style_properties(const std::vector<Style>& keys, FillRule fill_rule,
                                            int precision) {
  Properties properties(keys);
  const Style& first = keys.front();
  const bool silent = std::all_of(keys.begin(), keys.end(),
                                  [](const Style& key) { return key.fill.kind == Paint::Kind::automatic; });
  if (!silent) properties.add("fill", [](const Style& key) { return color_text(key.fill); });
  if (first.fill.paints()) {
    const char* const rule = fill_rule == FillRule::evenodd ? "evenodd" : kInitialRule;
    properties.add("fill-rule", [&](const Style&) { return std::string(rule); });
    properties.add_opacity("fill-opacity", &Style::fill);
  }
  if (!first.stroke.paints()) return properties.take();
  properties.add("stroke", [](const Style& key) { return color_text(key.stroke); });
  properties.add_opacity("stroke-opacity", &Style::stroke);
  properties.add("stroke-width",
                 [&](const Style& key) { return format_number(key.stroke_width, precision); });
  properties.add("stroke-linecap", [](const Style& key) { return std::string(text_of(key.line_cap)); });
  properties.add("stroke-linejoin", [](const Style& key) { return std::string(text_of(key.line_join)); });
  if (first.line_join == LineJoin::miter && first.miter_limit != kMiterLimit) {
    properties.add("stroke-miterlimit",
                   [](const Style& key) { return format_number(key.miter_limit, kDecimals); });
  }
  return properties.take();
}

std::string attributes_text(const std::vector<StyleProperty>& properties, std::size_t key) {
  std::string text;
  for (const StyleProperty& property : properties) {
    if (property.name == "fill-rule" && property.values[key] == kInitialRule) continue;
    text += fmt::format("{}=\"{}\" ", property.name, property.values[key]);
  }
  return text;
}

std::string attributes_text(const Style& style, FillRule fill_rule, int precision) {
  return attributes_text(style_properties({style}, fill_rule, precision));
}

}  // namespace v0
}  // namespace tandem
