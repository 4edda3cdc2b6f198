#include <vector>

#include "check.h"
#include "tandem/error.h"
#include "tandem/io/path_data.h"

/// Whatever is read can be written, and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<tandem::CubicPath> paths;
  try {
    paths = tandem::parse_path_data(tandem::fuzz::text(data, size));
  } catch (const tandem::ParseError&) {
    return 0;
  }
  for (const tandem::CubicPath& path : paths) tandem::fuzz::require_in_range(path.control_points().data());
  (void)tandem::parse_path_data(tandem::format_path_data(paths), "written");
  return 0;
}
