#include "io/itd_lexer.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/text_position.h"

namespace tandem {
inline namespace v0 {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

bool ends_word(char c) {
  return is_blank(c) || c == '[' || c == ']' || c == '"';
}

}  // namespace

ItdToken ItdLexer::next() {
  if (has_peeked_) {
    has_peeked_ = false;
    return peeked_;
  }
  return scan();
}

const ItdToken& ItdLexer::peek() {
  if (!has_peeked_) {
    peeked_ = scan();
    has_peeked_ = true;
  }
  return peeked_;
}

void ItdLexer::fail(std::size_t offset, const std::string& message) const {
  fail_at(source_, text_, offset, message);
}

void ItdLexer::fail_expected(std::string_view what, const ItdToken& found) const {
  constexpr std::size_t kShown = 30;
  const std::string text(found.text.substr(0, kShown));
  const std::string shown = found.kind == ItdKind::quoted ? fmt::format("\"{}\"", text)
                            : found.kind == ItdKind::word ? fmt::format("'{}'", text)
                                                          : describe_character(text_, found.offset);
  fail(found.offset, fmt::format("expected {}, found {}", what, shown));
}

ItdToken ItdLexer::scan() {
  if (depth_ == 0) skip_commentary();
  while (position_ < text_.size() && (is_blank(text_[position_]) || text_[position_] == ';')) {
    if (text_[position_] == ';') {
      position_ = std::min(text_.find('\n', position_), text_.size());
    } else {
      ++position_;
    }
  }
  if (position_ >= text_.size()) {
    if (depth_ > 0) fail(opened_at_, "this '[' is never closed");
    return {ItdKind::end, {}, text_.size()};
  }
  const std::size_t start = position_;
  switch (text_[start]) {
    case '[':
      if (depth_++ == 0) opened_at_ = start;
      ++position_;
      return {ItdKind::open, text_.substr(start, 1), start};
    case ']':
      --depth_;  // commentary is skipped outside of brackets, so one is open here
      ++position_;
      return {ItdKind::close, text_.substr(start, 1), start};
    case '"':
      return scan_quoted();
    default:
      return scan_word();
  }
}

ItdToken ItdLexer::scan_quoted() {
  const std::size_t start = position_;
  for (std::size_t i = start + 1; i < text_.size() && text_[i] != '\n'; ++i) {
    if (text_[i] == '\\') {
      ++i;
    } else if (text_[i] == '"') {
      position_ = i + 1;
      return {ItdKind::quoted, text_.substr(start + 1, i - start - 1), start};
    }
  }
  fail(start, "this string is not closed on its line");
}

ItdToken ItdLexer::scan_word() {
  const std::size_t start = position_;
  while (position_ < text_.size() && !ends_word(text_[position_])) ++position_;
  return {ItdKind::word, text_.substr(start, position_ - start), start};
}

void ItdLexer::skip_commentary() {
  position_ = std::min(text_.find('[', position_), text_.size());
}

}  // namespace v0
}  // namespace tandem
