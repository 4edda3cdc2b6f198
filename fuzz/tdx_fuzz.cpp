#include <string>
#include <vector>

#include "check.h"
#include "tandem/error.h"
#include "tandem/io/tdx.h"

/// Whatever is read is written so that it reads back equal.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<tandem::ShapeDescriptor> shapes;
  try {
    shapes = tandem::parse_tdx(tandem::fuzz::text(data, size));
  } catch (const tandem::ParseError&) {
    return 0;
  }
  for (const tandem::ShapeDescriptor& shape : shapes) {
    tandem::fuzz::require(shape.size() >= 1 && shape.tangents().size() == shape.size());
    for (const double length : shape.lengths()) tandem::fuzz::require(length > 0.0 && length < 1.1);
  }
  tandem::fuzz::require(tandem::parse_tdx(tandem::format_tdx(shapes)) == shapes);
  return 0;
}
