#include "names.h"

#include <cstddef>

namespace cli {

std::string short_name(const std::string& input) {
  if (input.empty() || input == "-") return "standard input";
  if ((input.front() == 'M' || input.front() == 'm') && input.find_first_of(" ,") != std::string::npos)
    return "path";
  const std::string name = input.substr(input.find_last_of('/') + 1);
  const std::size_t dot = name.find('.');
  const std::string stem = dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
  const std::size_t part = name.find('#');
  return part == std::string::npos || part < dot ? stem : stem + " " + name.substr(part + 1);
}

std::string title(const std::vector<std::string>& inputs) {
  std::string text;
  for (const std::string& input : inputs) text += (text.empty() ? "" : " \u2192 ") + short_name(input);
  return text;
}

}  // namespace cli
