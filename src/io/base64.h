#pragma once

#include <string>
#include <string_view>

namespace tandem {
inline namespace v0 {

/// RFC 4648, with padding.
[[nodiscard]] std::string to_base64(std::string_view bytes);

}  // namespace v0
}  // namespace tandem
