#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

namespace tandem {
inline namespace v0 {
namespace detail {

/// The 64-bit FNV-1a hash, of numbers byte by byte, the lowest first: the same on every machine.
class Fnv {
 public:
  void add_word(std::uint64_t word) noexcept {
    for (int k = 0; k < 8; ++k) {
      value_ = (value_ ^ (word & 0xFFU)) * 0x100000001B3U;
      word >>= 8U;
    }
  }
  void add_bytes(std::string_view bytes) noexcept {
    for (const char c : bytes) value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  }
  void add_number(double number) noexcept {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    add_word(bits);
  }
  [[nodiscard]] std::uint64_t value() const noexcept { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325U;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
