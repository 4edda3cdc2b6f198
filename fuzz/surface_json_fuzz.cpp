#include <optional>

#include "check.h"
#include "tandem/error.h"
#include "tandem/io/surface_json.h"

/// Whatever is read is written so that it reads back equal.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::optional<tandem::Surface> surface;
  try {
    surface = tandem::parse_json_surface(tandem::fuzz::text(data, size));
  } catch (const tandem::ParseError&) {
    return 0;
  }
  tandem::fuzz::require_in_range(surface->control_points().data());
  tandem::fuzz::require(tandem::is_json_surface(tandem::fuzz::text(data, size)));
  tandem::fuzz::require(tandem::parse_json_surface(tandem::format_json_surface(*surface)) == *surface);
  return 0;
}
