#pragma once

#include <array>
#include <cstdint>

namespace tandem {
inline namespace v0 {

/// What pictures are drawn in: as text, and as red, green, blue.
inline constexpr const char* kInk = "#1f2733";
inline constexpr std::array<std::uint8_t, 3> kInkColor = {0x1f, 0x27, 0x33};

}  // namespace v0
}  // namespace tandem
