#pragma once

#include <map>
#include <string>

namespace tandem::figures {

/// Figures 1 to 5 of [D], by file name.
[[nodiscard]] std::map<std::string, std::string> segment_figures();

}  // namespace tandem::figures
