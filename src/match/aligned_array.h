#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>

namespace tandem {
inline namespace v0 {
namespace detail {

/// A fixed number of values whose first one lies on a boundary of 64 bytes, as vector loads like it best.
template <class V>
class AlignedArray {
 public:
  AlignedArray(std::size_t size, V value) : values_(allocate(size)) {
    std::fill_n(values_.get(), size, value);
  }

  [[nodiscard]] V* data() noexcept { return values_.get(); }
  [[nodiscard]] const V* data() const noexcept { return values_.get(); }
  [[nodiscard]] V& operator[](std::size_t k) noexcept { return values_[k]; }
  [[nodiscard]] V operator[](std::size_t k) const noexcept { return values_[k]; }

 private:
  static constexpr std::align_val_t kAlignment{64};
  struct Free {
    void operator()(V* values) const noexcept { ::operator delete(values, kAlignment); }
  };
  static V* allocate(std::size_t size) {
    return static_cast<V*>(::operator new(std::max<std::size_t>(size, 1) * sizeof(V), kAlignment));
  }

  std::unique_ptr<V[], Free> values_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
