#pragma once

#include <string>
#include <vector>

namespace cli {

/// What an input is called in a title: the last part of a path without its ending; path data has no name.
[[nodiscard]] std::string short_name(const std::string& input);

/// "crow \u2192 kangaroo".
[[nodiscard]] std::string title(const std::vector<std::string>& inputs);

}  // namespace cli
