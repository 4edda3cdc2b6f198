#include "easing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "values.h"

namespace cli {

std::string parse_easing(const std::string& text) {
  constexpr std::array<std::string_view, 5> kNames = {"linear", "ease", "ease-in", "ease-out", "ease-in-out"};
  if (std::find(kNames.begin(), kNames.end(), text) != kNames.end()) return text;

  std::string list = text;
  constexpr std::string_view kHead = "cubic-bezier(";
  if (list.rfind(kHead, 0) == 0 && list.back() == ')')
    list = list.substr(kHead.size(), list.size() - kHead.size() - 1);
  if (list.find(',') == std::string::npos) std::replace(list.begin(), list.end(), ' ', ',');
  list.erase(std::remove(list.begin(), list.end(), ' '), list.end());
  const std::vector<std::string> parts =
      list.empty() ? std::vector<std::string>{} : split_list("--easing", list);
  if (parts.size() != 4) {
    throw UsageError(fmt::format(
        "--easing takes one of linear, ease, ease-in, ease-out, ease-in-out, or x1,y1,x2,y2, not '{}'",
        text));
  }
  // SMIL's keySplines take no others (SVG Animations 2, 2.16), and the player speaks the same.
  return fmt::format("{} {} {} {}", parse_number("--easing x1", parts[0], 0.0, 1.0),
                     parse_number("--easing y1", parts[1], 0.0, 1.0),
                     parse_number("--easing x2", parts[2], 0.0, 1.0),
                     parse_number("--easing y2", parts[3], 0.0, 1.0));
}

}  // namespace cli
