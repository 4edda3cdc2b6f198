#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cli {

/// The known word that `word` was probably meant to be, or "" when none is near.
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace cli
