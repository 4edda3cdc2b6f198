#pragma once

#include <map>
#include <string>

namespace tandem::figures {

/// The pictures of docs/skins.md, by their names.
[[nodiscard]] std::map<std::string, std::string> skin_figures();

}  // namespace tandem::figures
