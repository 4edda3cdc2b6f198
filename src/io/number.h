#pragma once

#include <string>

namespace tandem {
inline namespace v0 {

/// Appends x as text for SVG and JavaScript. precision < 0: the shortest text that reads back equal;
/// otherwise so many decimals, trailing zeros left out. Plain decimals from 1e-7 up to 1e21, a leading zero
/// before the point, and never a negative zero. x must be finite.
void append_number(std::string& text, double x, int precision = -1);

[[nodiscard]] std::string format_number(double x, int precision = -1);

}  // namespace v0
}  // namespace tandem
