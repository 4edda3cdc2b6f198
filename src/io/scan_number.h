#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace tandem {
inline namespace v0 {

/// Numbers in all the text formats: an optional sign, digits with an optional point before, between or after
/// them, an optional exponent. No locale, no "inf" or "nan"; correctly rounded.
struct ScannedNumber {
  double value = 0.0;      ///< infinite when the text is beyond double's range
  std::size_t length = 0;  ///< bytes read
};

/// The longest number at the start of `text`; nothing when there is none. An `e` that no digits follow is
/// left alone ("1em" is 1 and a unit).
[[nodiscard]] std::optional<ScannedNumber> scan_number(std::string_view text);

/// Whether a number starts `text`: cheaper than reading it.
[[nodiscard]] bool starts_number(std::string_view text);

/// The number that all of `text` is; nothing when it is not one, or not finite.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

}  // namespace v0
}  // namespace tandem
