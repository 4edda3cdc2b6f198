#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tandem {
inline namespace v0 {

/// What a file holds. json_lines and index hold many shapes: they are corpora (tandem/io/corpus.h).
enum class FileFormat { svg, font, json, json_lines, index, itd, csv, path_data, cad, compressed, unknown };

/// By the ending of the name, without regard to case.
[[nodiscard]] FileFormat format_of_extension(std::string_view path);

/// A file and what is wanted of it.
struct FilePart {
  std::string path;
  std::optional<std::string> part;
};

/// An existing file wins; of the ways to cut FILE#PART the one with the longest existing file.
[[nodiscard]] std::optional<FilePart> existing_file(const std::string& name);

}  // namespace v0
}  // namespace tandem
