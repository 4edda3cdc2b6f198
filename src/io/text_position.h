#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace tandem {
inline namespace v0 {

/// A place in a text, both counted from 1; a column is a character (UTF-8 code point), not a byte.
struct TextPosition {
  int line = 1;
  int column = 1;
};

/// Where byte `offset` of `text` stands. Lines end with LF, CR LF or CR.
[[nodiscard]] TextPosition locate(std::string_view text, std::size_t offset);

/// Throws the ParseError for byte `offset` of `text`.
[[noreturn]] void fail_at(const std::string& source, std::string_view text, std::size_t offset,
                          const std::string& message);

/// What the readers of small grammars (path data, transforms, lengths) throw: they know the offset in their
/// own text; whoever called them knows where in the file that text stands.
struct SyntaxError {
  std::size_t offset = 0;
  std::string message;
};

/// The text without a UTF-8 byte order mark.
[[nodiscard]] std::string_view without_bom(std::string_view text);

/// How the character at `offset` is named in a message: 'x', "the end", "byte 0x07".
[[nodiscard]] std::string describe_character(std::string_view text, std::size_t offset);

}  // namespace v0
}  // namespace tandem
