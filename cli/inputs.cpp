#include <fmt/format.h>

#include <algorithm>

#include "commands.h"
#include "drawings.h"
#include "tandem/error.h"
#include "tandem/io/load_surface.h"
#include "usage_error.h"

namespace cli {

void check_standard_input(const Command& command) {
  if (std::count(command.inputs.begin(), command.inputs.end(), "-") > 1)
    throw UsageError("standard input can be read only once");
}

namespace {

void check_count(const Command& command, std::size_t least, std::size_t most) {
  const std::size_t count = command.inputs.size();
  if (count >= least && count <= most) return;
  const std::string wanted = least == most ? fmt::format("{}", least) : fmt::format("{} or more", least);
  throw UsageError(fmt::format("{} takes {} curve{} or shape{}, not {}", command.app->get_name(), wanted,
                               most == 1 ? "" : "s", most == 1 ? "" : "s", count));
}

void check_contours(const tandem::Shape& shape, const std::string& name) {
  if (shape.contours.empty()) throw tandem::InvalidArgument(name + ": holds no contour");
}

}  // namespace

std::variant<tandem::Shape, tandem::Surface> load_any_input(const Command& command) {
  check_count(command, 1, 1);
  const std::string& name = command.inputs.front();
  std::variant<tandem::Shape, tandem::Surface> loaded =
      tandem::load_shape_or_surface(name, to_load_options(command.common));
  if (const auto* shape = std::get_if<tandem::Shape>(&loaded)) check_contours(*shape, name);
  return loaded;
}

std::vector<tandem::Drawing> load_drawings(const Command& command, std::size_t least, std::size_t most) {
  const std::vector<std::string>& names = command.inputs;
  check_count(command, least, most);
  check_standard_input(command);
  const tandem::LoadOptions options = to_load_options(command.common);
  std::vector<tandem::Drawing> drawings;
  drawings.reserve(names.size());
  for (const std::string& name : names) {
    drawings.push_back(tandem::load_drawing(name, options));
    check_contours(drawings.back().shape, name);
  }
  return drawings;
}

std::vector<tandem::Shape> shapes_of(const std::vector<tandem::Drawing>& drawings) {
  std::vector<tandem::Shape> shapes;
  shapes.reserve(drawings.size());
  for (const tandem::Drawing& drawing : drawings) shapes.push_back(drawing.shape);
  return shapes;
}

std::vector<tandem::Shape> load_inputs(const Command& command, std::size_t least, std::size_t most) {
  return shapes_of(load_drawings(command, least, most));
}

}  // namespace cli
