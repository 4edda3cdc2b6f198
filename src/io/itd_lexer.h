#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tandem {
inline namespace v0 {

enum class ItdKind { open, close, word, quoted, end };

struct ItdToken {
  ItdKind kind = ItdKind::end;
  std::string_view text;   ///< of a word; a quoted string without its quotes, its escapes left as they are
  std::size_t offset = 0;  ///< where it stands
};

/// Splits IRIT text data into brackets, words and quoted strings. Text outside of all brackets is commentary
/// (IRIT writes a header of that kind) and is passed over; so is everything from a word that starts with `;`
/// to the end of its line.
class ItdLexer {
 public:
  ItdLexer(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  ItdToken next();
  [[nodiscard]] const ItdToken& peek();
  /// Brackets that are open.
  [[nodiscard]] std::size_t depth() const noexcept { return depth_; }
  [[noreturn]] void fail(std::size_t offset, const std::string& message) const;
  /// "expected <what>, found ...".
  [[noreturn]] void fail_expected(std::string_view what, const ItdToken& found) const;

 private:
  ItdToken scan();
  ItdToken scan_quoted();
  ItdToken scan_word();
  void skip_commentary();

  std::string_view text_;
  const std::string& source_;
  std::size_t position_ = 0;
  std::size_t depth_ = 0;      ///< of the tokens handed out and the peeked one
  std::size_t opened_at_ = 0;  ///< offset of the outermost open bracket
  ItdToken peeked_;
  bool has_peeked_ = false;
};

}  // namespace v0
}  // namespace tandem
