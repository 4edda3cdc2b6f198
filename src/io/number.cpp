#include "io/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

namespace tandem {
inline namespace v0 {
namespace {

// The range in which JavaScript, too, writes plain decimals.
constexpr double kPlainFrom = 1e-7;
constexpr double kPlainBelow = 1e21;

// More decimals than any double of the plain range has.
constexpr int kMostDecimals = 30;

// Decimals and sizes (in units of the last decimal) for which a product of doubles tells how x is rounded.
constexpr int kQuickDecimals = 9;
constexpr double kQuickSize = 1e9;
// How far a product below kQuickSize may be off, with room to spare: nearer to a half, nobody knows.
constexpr double kUnsure = 1e-5;

// Rounds to `precision` decimals as fmt does, some ten times faster. False: this number is none for it.
bool append_quickly(std::string& text, double x, int precision) {
  if (precision > kQuickDecimals) return false;
  constexpr std::array<double, kQuickDecimals + 1> kPowers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
  const double scaled = std::fabs(x) * kPowers[static_cast<std::size_t>(precision)];
  if (!(scaled < kQuickSize)) return false;
  const auto floor = static_cast<std::uint64_t>(scaled);
  const double rest = scaled - static_cast<double>(floor);
  if (std::fabs(rest - 0.5) < kUnsure) return false;
  std::uint64_t value = floor + (rest > 0.5 ? 1 : 0);
  if (value == 0) {
    text += '0';
    return true;
  }
  int decimals = precision;
  for (; decimals > 0 && value % 10 == 0; --decimals) value /= 10;
  std::array<char, 24> digits;  // from the back
  char* const end = digits.data() + digits.size();
  char* at = end;
  for (int k = 0; value > 0 || k <= decimals; ++k, value /= 10) {
    if (k == decimals && k > 0) *--at = '.';
    *--at = static_cast<char>('0' + value % 10);
  }
  if (std::signbit(x)) *--at = '-';
  text.append(at, static_cast<std::size_t>(end - at));
  return true;
}

// "1.25e-05" -> "0.0000125", "1e+17" -> "100000000000000000"
void append_plain(std::string& text, std::string_view scientific) {
  const std::size_t e = scientific.find('e');
  std::string_view mantissa = scientific.substr(0, e);
  int exponent = 0;
  for (char c : scientific.substr(e + 2)) exponent = 10 * exponent + (c - '0');
  if (mantissa.front() == '-') {
    text += '-';
    mantissa.remove_prefix(1);
  }
  std::string digits(1, mantissa.front());
  if (mantissa.size() > 2) digits += mantissa.substr(2);
  if (scientific[e + 1] == '-') {
    text += "0.";
    text.append(static_cast<std::size_t>(exponent - 1), '0');
    text += digits;
  } else {
    // fmt turns to exponents at 1e16 only, and no double has more than 17 digits: the point never comes back.
    digits.resize(std::max(digits.size(), static_cast<std::size_t>(exponent) + 1), '0');
    text += digits;
  }
}

}  // namespace

void append_number(std::string& text, double x, int precision) {
  const double size = std::fabs(x);
  if (x == 0.0) {
    text += '0';
    return;
  }
  if (precision >= 0 && append_quickly(text, x, precision)) return;
  if (precision >= 0 && size < kPlainBelow) {
    const std::size_t start = text.size();
    fmt::format_to(std::back_inserter(text), "{:.{}f}", x, std::min(precision, kMostDecimals));
    if (text.find('.', start) != std::string::npos) {
      text.erase(text.find_last_not_of('0') + 1);
      if (text.back() == '.') text.pop_back();
    }
    if (std::string_view(text).substr(start) == "-0") text.replace(start, 2, "0");
    return;
  }
  const std::string shortest = fmt::format("{}", x);
  if (size >= kPlainFrom && size < kPlainBelow && shortest.find('e') != std::string::npos) {
    append_plain(text, shortest);
  } else {
    text += shortest;
  }
}

std::string format_number(double x, int precision) {
  std::string text;
  append_number(text, x, precision);
  return text;
}

}  // namespace v0
}  // namespace tandem
