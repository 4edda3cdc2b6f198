#include "easing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "values.h"

namespace cli {
namespace {

std::string trimmed(std::string text) {
  text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

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

}  // namespace

std::string parse_easings(const std::vector<std::string>& words, std::size_t steps) {
  std::string easings;
  std::size_t count = 0;
  for (const std::string& word : words) {
    for (std::size_t at = 0; at <= word.size();) {
      const std::size_t end = std::min(word.find(';', at), word.size());
      easings += (count++ == 0 ? "" : ";") + parse_easing(trimmed(word.substr(at, end - at)));
      at = end + 1;
    }
  }
  if (count != 1 && count != steps) {
    throw UsageError(fmt::format(
        "--easing takes one easing for all, or one for each of the {} steps from shape to shape, not {}",
        steps, count));
  }
  return easings;
}

}  // namespace cli
