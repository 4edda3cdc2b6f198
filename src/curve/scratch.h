#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace tandem {
inline namespace v0 {
namespace detail {

/// Room for `size` doubles: on the stack up to N, on the heap beyond. Not initialised.
template <std::size_t N>
class Scratch {
 public:
  explicit Scratch(std::size_t size)
      : heap_(size > N ? size : 0), data_(size > N ? heap_.data() : stack_.data()) {}
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] double* data() noexcept { return data_; }
  [[nodiscard]] double& operator[](std::size_t i) noexcept { return data_[i]; }

 private:
  std::array<double, N> stack_;
  std::vector<double> heap_;
  double* data_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
