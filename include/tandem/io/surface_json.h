#pragma once

#include <string>
#include <string_view>

#include "tandem/surface/surface.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// Reads a surface in the form of docs/interface.md ("bspline_surface"); other members are passed over.
/// @throws ParseError with line and column
[[nodiscard]] TANDEM_IO_EXPORT Surface parse_json_surface(std::string_view text,
                                                          const std::string& source = "json");

/// Whether the text is JSON that says it is a surface. False for text that is no JSON.
[[nodiscard]] TANDEM_IO_EXPORT bool is_json_surface(std::string_view text);

/// Writes it so that it reads back equal. members: more of them, `"report": {...}`; empty: none.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_json_surface(const Surface& surface,
                                                               std::string_view members = {});

}  // namespace v0
}  // namespace tandem
