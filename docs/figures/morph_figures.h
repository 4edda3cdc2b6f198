#pragma once

#include <map>
#include <string>

namespace tandem::figures {

/// Figures 8, 11 and 13 of [C], by file name.
[[nodiscard]] std::map<std::string, std::string> morph_figures();

}  // namespace tandem::figures
