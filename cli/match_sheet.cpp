#include "match_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "tandem/error.h"

namespace cli {
namespace {

/// A picture from its <svg> tag on, and its size.
struct Picture {
  std::string_view element;
  double width = 0.0;
  double height = 0.0;
};

Picture measure(const std::string& text) {
  constexpr std::string_view kViewBox = "viewBox=\"";
  const std::size_t start = text.find("<svg");
  const std::size_t box = text.find(kViewBox, start);
  if (start == std::string::npos || box == std::string::npos) {
    throw tandem::InvalidArgument("a picture without viewBox cannot be put on a sheet");
  }
  Picture picture{std::string_view(text).substr(start)};
  const char* number = text.c_str() + box + kViewBox.size();
  char* end = nullptr;
  std::strtod(number, &end);
  std::strtod(end, &end);
  picture.width = std::strtod(end, &end);
  picture.height = std::strtod(end, &end);
  return picture;
}

}  // namespace

std::string stack_pictures(const std::vector<std::string>& pictures) {
  if (pictures.size() == 1) return pictures.front();
  std::string rows;
  double width = 0.0;
  double height = 0.0;
  for (const std::string& text : pictures) {
    const Picture picture = measure(text);
    rows += fmt::format("<svg y=\"{}\" width=\"{}\" height=\"{}\">\n{}\n</svg>\n", height, picture.width,
                        picture.height, picture.element);
    width = std::max(width, picture.width);
    height += picture.height;
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\">\n{2}</svg>\n",
      width, height, rows);
}

}  // namespace cli
