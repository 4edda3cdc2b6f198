#include "check.h"
#include "tandem/error.h"
#include "tandem/io/csv.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const tandem::Curve curve = tandem::parse_csv(tandem::fuzz::text(data, size));
    for (const double x : curve.control_points().data()) tandem::fuzz::require(std::isfinite(x));
    for (const double x : curve.evaluate(curve.domain().lo)) tandem::fuzz::require(std::isfinite(x));
  } catch (const tandem::ParseError&) {
  }
  return 0;
}
