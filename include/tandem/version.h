#pragma once

#include <string_view>

#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// The version these headers belong to.
inline constexpr std::string_view kVersion = "0.1.0";

/// The version of the library that was linked, "MAJOR.MINOR.PATCH".
[[nodiscard]] TANDEM_EXPORT std::string_view version();

}  // namespace v0
}  // namespace tandem
