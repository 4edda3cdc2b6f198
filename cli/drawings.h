#pragma once

#include <cstddef>
#include <vector>

#include "commands.h"
#include "tandem/io/look.h"

namespace cli {

/// load_inputs() with how the shapes are drawn.
[[nodiscard]] std::vector<tandem::Drawing> load_drawings(const Command& command, std::size_t least,
                                                         std::size_t most);
[[nodiscard]] std::vector<tandem::Shape> shapes_of(const std::vector<tandem::Drawing>& drawings);

}  // namespace cli
