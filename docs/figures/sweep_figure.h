#pragma once

#include <map>
#include <string>

namespace tandem::figures {

/// [C] Figure 2: ruling and sweeping between two outlines with legs.
[[nodiscard]] std::map<std::string, std::string> sweep_figures();

}  // namespace tandem::figures
