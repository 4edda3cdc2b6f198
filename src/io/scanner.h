#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tandem {
inline namespace v0 {

/// Walks through the small grammars of SVG attributes. Whatever it expects and does not find is a
/// SyntaxError.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  [[nodiscard]] bool at_end() const noexcept { return position_ >= text_.size(); }
  [[nodiscard]] std::size_t position() const noexcept { return position_; }
  /// The next character; 0 at the end.
  [[nodiscard]] char peek() const noexcept { return at_end() ? '\0' : text_[position_]; }
  void advance() noexcept { ++position_; }

  /// Blanks, tabs and line ends, as SVG counts them.
  void skip_blanks() noexcept;
  /// Blanks with at most one comma among them; true if there was a comma.
  bool skip_comma_and_blanks() noexcept;
  /// Takes `c` if it comes next.
  bool accept(char c) noexcept;
  /// Whether a number starts here.
  [[nodiscard]] bool number_follows() const;
  /// The number that comes next, if one does; it must be finite.
  std::optional<double> try_number();
  /// A finite number; `what` names it in the error.
  double number(std::string_view what);
  /// A single 0 or 1, which needs nothing between itself and what follows.
  bool flag(std::string_view what);
  /// Letters and digits, as function names and units are made of; may be empty.
  std::string_view word() noexcept;

  /// "expected <what>, found 'x'".
  [[noreturn]] void fail_expected(std::string_view what) const;
  [[noreturn]] static void fail(std::size_t offset, std::string message);

 private:
  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace v0
}  // namespace tandem
