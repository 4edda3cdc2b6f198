#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// Content of a file, piece by piece; nothing: the end.
using FilePieces = std::function<std::optional<std::string>()>;

/// The whole file, or standard input for "-". @throws IoError
[[nodiscard]] TANDEM_IO_EXPORT std::string read_file(const std::string& path);

/// Writes the whole file or nothing: to a temporary file beside it, which then takes its name. "-" is
/// standard output. @throws IoError, and then no file was made or changed
TANDEM_IO_EXPORT void write_file(const std::string& path, std::string_view content);

/// The same for a file that may be larger than the memory; signals are not held back. NAME is called
/// .tandem-NAME until it is whole: what a process that was killed left behind under that name is overwritten,
/// so no two processes may write the same file. @throws IoError, also where `path` is no regular file; and
/// what `next` throws; no file was made or changed then
TANDEM_IO_EXPORT void write_file(const std::string& path, const FilePieces& next);

}  // namespace v0
}  // namespace tandem
