#include "io/file_format.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace tandem {
inline namespace v0 {
namespace {

struct Extension {
  std::string_view name;
  FileFormat format;
};

constexpr std::array<Extension, 22> kExtensions = {
    {{"svg", FileFormat::svg},          {"ttf", FileFormat::font},  {"otf", FileFormat::font},
     {"ttc", FileFormat::font},         {"otc", FileFormat::font},  {"woff", FileFormat::font},
     {"woff2", FileFormat::font},       {"pfb", FileFormat::font},  {"pfa", FileFormat::font},
     {"json", FileFormat::json},        {"itd", FileFormat::itd},   {"csv", FileFormat::csv},
     {"tsv", FileFormat::csv},          {"step", FileFormat::cad},  {"stp", FileFormat::cad},
     {"iges", FileFormat::cad},         {"igs", FileFormat::cad},   {"brep", FileFormat::cad},
     {"svgz", FileFormat::compressed},  {"tdx", FileFormat::index}, {"jsonl", FileFormat::json_lines},
     {"ndjson", FileFormat::json_lines}}};

bool exists(const std::string& path) {
  struct stat status {};
  return !path.empty() && ::stat(path.c_str(), &status) == 0;
}

}  // namespace

FileFormat format_of_extension(std::string_view path) {
  const std::size_t slash = path.find_last_of('/');
  if (slash != std::string_view::npos) path.remove_prefix(slash + 1);
  const std::size_t dot = path.find_last_of('.');
  if (dot == std::string_view::npos) return FileFormat::unknown;
  std::string extension(path.substr(dot + 1));
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const auto* found = std::find_if(kExtensions.begin(), kExtensions.end(),
                                   [&](const Extension& candidate) { return candidate.name == extension; });
  return found == kExtensions.end() ? FileFormat::unknown : found->format;
}

std::optional<FilePart> existing_file(const std::string& name) {
  if (exists(name)) return FilePart{name, std::nullopt};
  for (std::size_t mark = name.rfind('#'); mark != std::string::npos && mark > 0;
       mark = name.rfind('#', mark - 1)) {
    std::string path = name.substr(0, mark);
    if (mark + 1 < name.size() && exists(path)) return FilePart{std::move(path), name.substr(mark + 1)};
  }
  return std::nullopt;
}

}  // namespace v0
}  // namespace tandem
