#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/match/match.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// Reads curves in the form of docs/interface.md: one curve, an array, or {"curves": [...]}.
/// @throws ParseError with line and column for malformed JSON, and with the index of the curve for an invalid
/// one
[[nodiscard]] TANDEM_IO_EXPORT std::vector<Curve> parse_json_curves(std::string_view text,
                                                                    const std::string& source = "json");

/// Writes them so that they read back equal: one curve as an object, several as {"curves": [...]}.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_json_curves(std::span<const Curve> curves);

/// The report of one match, `curve` and all, as docs/interface.md has it.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_json_report(const Match& match);

}  // namespace v0
}  // namespace tandem
