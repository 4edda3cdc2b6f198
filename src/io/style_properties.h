#pragma once

#include <string>
#include <vector>

#include "io/layers.h"

namespace tandem {
inline namespace v0 {

/// A property by which SVG and CSS draw a layer, called alike in both.
struct StyleProperty {
  std::string name;
  std::vector<std::string> values;  ///< one per key

  [[nodiscard]] bool changes() const;
};

/// The fill rule, and those that are not as they are without being said. precision: decimals of lengths.
[[nodiscard]] std::vector<StyleProperty> style_properties(const std::vector<Style>& keys, FillRule fill_rule,
                                                          int precision);

/// `fill="none" stroke="currentColor" ... `: as at the key; each with a blank behind it. The
/// nonzero rule goes without saying.
[[nodiscard]] std::string attributes_text(const std::vector<StyleProperty>& properties, std::size_t key = 0);
[[nodiscard]] std::string attributes_text(const Style& style, FillRule fill_rule, int precision);

}  // namespace v0
}  // namespace tandem
