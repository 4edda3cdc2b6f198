#include "io/scan_number.h"

#include <fast_float/fast_float.h>

#include <cmath>
#include <cstddef>

namespace tandem {
inline namespace v0 {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::size_t skip_digits(std::string_view text, std::size_t i) {
  while (i < text.size() && is_digit(text[i])) ++i;
  return i;
}

/// Length of the number at the start of `text`, 0 without one.
std::size_t number_length(std::string_view text) {
  std::size_t i = 0;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
  const std::size_t whole = i;
  i = skip_digits(text, i);
  std::size_t digits = i - whole;
  if (i < text.size() && text[i] == '.') {
    const std::size_t fraction = i + 1;
    const std::size_t end = skip_digits(text, fraction);
    digits += end - fraction;
    if (digits == 0) return 0;
    i = end;
  }
  if (digits == 0) return 0;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    std::size_t exponent = i + 1;
    if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
    const std::size_t end = skip_digits(text, exponent);
    if (end > exponent) i = end;
  }
  return i;
}

}  // namespace

std::optional<ScannedNumber> scan_number(std::string_view text) {
  const std::size_t length = number_length(text);
  if (length == 0) return std::nullopt;
  const char* first = text.data();
  const char* last = first + length;
  if (*first == '+') ++first;  // fast_float takes no plus sign
  double value = 0.0;
  fast_float::from_chars(first, last, value);
  return ScannedNumber{value, length};
}

bool starts_number(std::string_view text) {
  if (!text.empty() && (text.front() == '+' || text.front() == '-')) text.remove_prefix(1);
  if (!text.empty() && text.front() == '.') text.remove_prefix(1);
  return !text.empty() && is_digit(text.front());
}

std::optional<double> parse_number(std::string_view text) {
  const std::optional<ScannedNumber> number = scan_number(text);
  if (!number || number->length != text.size() || !std::isfinite(number->value)) return std::nullopt;
  return number->value;
}

}  // namespace v0
}  // namespace tandem
