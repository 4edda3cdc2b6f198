#pragma once

#include <map>
#include <string>

namespace tandem::figures {

/// The pictures of docs/morphs.md and docs/motions.md that show several keys, and motions.
[[nodiscard]] std::map<std::string, std::string> key_figures();

}  // namespace tandem::figures
