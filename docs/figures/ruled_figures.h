#pragma once

#include <map>
#include <string>

namespace tandem::figures {

/// Figures 1, 3, 4, 7 and 10 of [C], as far as they are ruled or blend surfaces, by file name.
[[nodiscard]] std::map<std::string, std::string> ruled_figures();

}  // namespace tandem::figures
