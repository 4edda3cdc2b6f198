#include <vector>

#include "check.h"
#include "tandem/error.h"
#include "tandem/io/svg.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = tandem::fuzz::text(data, size);
  const auto check = [](const std::vector<tandem::SvgElement>& elements) {
    tandem::fuzz::require(!elements.empty());
    for (const tandem::SvgElement& element : elements) {
      tandem::fuzz::require(!element.shape.contours.empty());
      for (const tandem::Curve& curve : element.shape.contours) {
        tandem::fuzz::require_in_range(curve.control_points().data());
      }
    }
  };
  try {
    check(tandem::parse_svg(text));
  } catch (const tandem::ParseError&) {
  }
  try {
    check(tandem::parse_svg_part(text, "a"));
  } catch (const tandem::ParseError&) {
  }
  return 0;
}
