#pragma once

#include <string>
#include <string_view>

#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// The whole file, or standard input for "-". @throws IoError
[[nodiscard]] TANDEM_IO_EXPORT std::string read_file(const std::string& path);

/// Writes the whole file or nothing: to a temporary file beside it, which then takes its name. "-" is
/// standard output. @throws IoError, and then no file was made or changed
TANDEM_IO_EXPORT void write_file(const std::string& path, std::string_view content);

}  // namespace v0
}  // namespace tandem
