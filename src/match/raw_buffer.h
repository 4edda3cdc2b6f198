#pragma once

#include <cstddef>
#include <memory>

namespace tandem {
inline namespace v0 {
namespace detail {

/// Memory for numbers that are written before they are read. Filling the tables of edges with zeros took a
/// tenth of the time of a match, and touched pages that a band never comes to.
class RawBuffer {
 public:
  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] double* data() noexcept { return values_.get(); }
  /// Keeps the memory, but not what it holds.
  void clear() noexcept { size_ = 0; }
  /// Of an empty buffer: what it holds afterwards is not defined.
  void resize(std::size_t size) {
    if (size > capacity_) {
      values_.reset();
      values_.reset(new double[size]);
      capacity_ = size;
    }
    size_ = size;
  }

 private:
  std::unique_ptr<double[]> values_;
  std::size_t capacity_ = 0;
  std::size_t size_ = 0;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
