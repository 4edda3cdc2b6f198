#include "io/text_position.h"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

TextPosition locate(std::string_view text, std::size_t offset) {
  TextPosition position;
  offset = std::min(offset, text.size());
  for (std::size_t i = 0; i < offset; ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const bool lone_return = c == '\r' && !(i + 1 < text.size() && text[i + 1] == '\n');
    if (c == '\n' || lone_return) {
      ++position.line;
      position.column = 1;
    } else if ((c & 0xC0U) != 0x80U) {  // not a continuation byte of UTF-8
      ++position.column;
    }
  }
  return position;
}

void fail_at(const std::string& source, std::string_view text, std::size_t offset,
             const std::string& message) {
  const TextPosition position = locate(text, offset);
  throw ParseError(source, position.line, position.column, message);
}

std::string_view without_bom(std::string_view text) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  return text;
}

std::string describe_character(std::string_view text, std::size_t offset) {
  if (offset >= text.size()) return "the end";
  const auto c = static_cast<unsigned char>(text[offset]);
  if (c >= 0x21 && c < 0x7F) return fmt::format("'{}'", text[offset]);
  if (c == ' ' || c == '\t') return "a blank";
  if (c == '\n' || c == '\r') return "the end of the line";
  if (c >= 0xC2 && c < 0xF5) {
    const std::size_t length = c < 0xE0 ? 2 : c < 0xF0 ? 3 : 4;
    const std::string_view character = text.substr(offset, length);
    const bool whole = character.size() == length &&
                       std::all_of(character.begin() + 1, character.end(),
                                   [](char b) { return (static_cast<unsigned char>(b) & 0xC0U) == 0x80U; });
    if (whole) return fmt::format("'{}'", character);
  }
  return fmt::format("byte 0x{:02X}", c);
}

}  // namespace v0
}  // namespace tandem
