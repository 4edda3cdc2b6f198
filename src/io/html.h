#pragma once

#include <string>
#include <string_view>

namespace tandem {
inline namespace v0 {

/// The text with the characters that mean something in HTML and SVG replaced.
[[nodiscard]] std::string escape_html(std::string_view text);

[[nodiscard]] std::string replace_all(std::string_view text, std::string_view what, std::string_view by);

}  // namespace v0
}  // namespace tandem
