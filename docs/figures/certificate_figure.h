#pragma once

#include <string>

namespace tandem::figures {

/// Certificates of three planar ruled surfaces: what is proved, and the witnesses where it is disproved.
[[nodiscard]] std::string certificate_figure();

}  // namespace tandem::figures
