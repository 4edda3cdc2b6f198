#pragma once

#include <string>

#include "tandem/shape/shape.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// The outline of a glyph in font units, y up. glyph: a character (UTF-8), "uniXXXX", "uXXXXX", or a glyph
/// name.
/// @throws IoError the file cannot be read; ParseError it is no font, or has no such glyph or no outline for
/// it
[[nodiscard]] TANDEM_IO_EXPORT Shape read_glyph(const std::string& path, const std::string& glyph);

}  // namespace v0
}  // namespace tandem
