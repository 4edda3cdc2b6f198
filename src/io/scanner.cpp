#include "io/scanner.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "io/scan_number.h"
#include "io/text_position.h"

namespace tandem {
inline namespace v0 {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

bool is_word_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

}  // namespace

void Scanner::skip_blanks() noexcept {
  while (is_blank(peek())) advance();
}

bool Scanner::skip_comma_and_blanks() noexcept {
  skip_blanks();
  const bool comma = accept(',');
  if (comma) skip_blanks();
  return comma;
}

bool Scanner::accept(char c) noexcept {
  if (at_end() || text_[position_] != c) return false;
  advance();
  return true;
}

bool Scanner::number_follows() const {
  return starts_number(text_.substr(position_));
}

std::optional<double> Scanner::try_number() {
  const std::optional<ScannedNumber> number = scan_number(text_.substr(position_));
  if (!number) return std::nullopt;
  if (!std::isfinite(number->value)) fail(position_, "the number is out of range");
  position_ += number->length;
  return number->value;
}

double Scanner::number(std::string_view what) {
  if (const std::optional<double> value = try_number()) return *value;
  fail_expected(what);
}

bool Scanner::flag(std::string_view what) {
  const char c = peek();
  if (c != '0' && c != '1') fail_expected(fmt::format("{} (0 or 1)", what));
  advance();
  return c == '1';
}

std::string_view Scanner::word() noexcept {
  const std::size_t start = position_;
  while (!at_end() && is_word_character(text_[position_])) advance();
  return text_.substr(start, position_ - start);
}

void Scanner::fail_expected(std::string_view what) const {
  fail(position_, fmt::format("expected {}, found {}", what, describe_character(text_, position_)));
}

void Scanner::fail(std::size_t offset, std::string message) {
  throw SyntaxError{offset, std::move(message)};
}

}  // namespace v0
}  // namespace tandem
