#include <fmt/format.h>

#include <algorithm>

#include "commands.h"
#include "tandem/error.h"
#include "usage_error.h"

namespace cli {

void check_standard_input(const Command& command) {
  if (std::count(command.inputs.begin(), command.inputs.end(), "-") > 1)
    throw UsageError("standard input can be read only once");
}

std::vector<tandem::Shape> load_inputs(const Command& command, std::size_t least, std::size_t most) {
  const std::vector<std::string>& names = command.inputs;
  if (names.size() < least || names.size() > most) {
    const std::string wanted = least == most ? fmt::format("{}", least) : fmt::format("{} or more", least);
    throw UsageError(fmt::format("{} takes {} curve{} or shape{}, not {}", command.app->get_name(), wanted,
                                 most == 1 ? "" : "s", most == 1 ? "" : "s", names.size()));
  }
  check_standard_input(command);
  const tandem::LoadOptions options = to_load_options(command.common);
  std::vector<tandem::Shape> shapes;
  shapes.reserve(names.size());
  for (const std::string& name : names) {
    shapes.push_back(tandem::load_shape(name, options));
    if (shapes.back().contours.empty()) throw tandem::InvalidArgument(name + ": holds no contour");
  }
  return shapes;
}

}  // namespace cli
