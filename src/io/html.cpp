#include "io/html.h"

#include <cstddef>

namespace tandem {
inline namespace v0 {

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string replace_all(std::string_view text, std::string_view what, std::string_view by) {
  std::string result;
  for (std::size_t at = 0;;) {
    const std::size_t next = text.find(what, at);
    result += text.substr(at, next - at);
    if (next == std::string_view::npos) return result;
    result += by;
    at = next + what.size();
  }
}

}  // namespace v0
}  // namespace tandem
