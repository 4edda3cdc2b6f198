#include <string>
#include <vector>

#include "check.h"
#include "tandem/error.h"
#include "tandem/io/itd.h"

/// Whatever is read is written so that it reads back equal; rational curves from the second time on.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<tandem::Curve> curves;
  try {
    curves = tandem::parse_itd(tandem::fuzz::text(data, size));
  } catch (const tandem::ParseError&) {
    return 0;
  }
  bool rational = false;
  for (const tandem::Curve& curve : curves) {
    tandem::fuzz::require_in_range(curve.control_points().data());
    rational = rational || curve.is_rational();
  }
  std::string text;
  try {
    text = tandem::format_itd(curves);
  } catch (const tandem::InvalidArgument&) {
    tandem::fuzz::require(rational);  // a coordinate times its weight overflows
    return 0;
  }
  if (!rational) tandem::fuzz::require(tandem::parse_itd(text) == curves);
  return 0;
}
