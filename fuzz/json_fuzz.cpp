#include <vector>

#include "check.h"
#include "tandem/error.h"
#include "tandem/io/json.h"

/// Whatever is read is written so that it reads back equal.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<tandem::Curve> curves;
  try {
    curves = tandem::parse_json_curves(tandem::fuzz::text(data, size));
  } catch (const tandem::ParseError&) {
    return 0;
  }
  for (const tandem::Curve& curve : curves) tandem::fuzz::require_in_range(curve.control_points().data());
  tandem::fuzz::require(tandem::parse_json_curves(tandem::format_json_curves(curves)) == curves);
  return 0;
}
