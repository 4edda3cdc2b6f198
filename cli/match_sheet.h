#pragma once

#include <string>
#include <vector>

namespace cli {

/// One SVG document with the pictures (SVG documents with a viewBox) below each other.
[[nodiscard]] std::string stack_pictures(const std::vector<std::string>& pictures);

}  // namespace cli
