#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

namespace tandem {
inline namespace v0 {
namespace detail {

/// Memory for numbers that are written before they are read. Filling the tables of edges with zeros took a
/// tenth of the time of a match, and touched pages that a band never comes to. Getting the pages anew for
/// every match took another tenth: each thread keeps the last blocks of moderate size for the next match.
class RawBuffer {
 public:
  RawBuffer() = default;
  RawBuffer(const RawBuffer&) = delete;
  RawBuffer& operator=(const RawBuffer&) = delete;
  ~RawBuffer() { give_back(); }

  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] double* data() noexcept { return block_.values.get(); }
  /// Keeps the memory, but not what it holds.
  void clear() noexcept { size_ = 0; }
  /// Of an empty buffer: what it holds afterwards is not defined.
  void resize(std::size_t size) {
    if (size > block_.capacity) {
      give_back();
      for (Block& kept : kept_blocks()) {
        if (kept.capacity < size) continue;
        std::swap(block_, kept);
        break;
      }
    }
    if (size > block_.capacity) {
      block_ = {};
      block_.values.reset(new double[size]);
      block_.capacity = size;
    }
    size_ = size;
  }

 private:
  struct Block {
    std::unique_ptr<double[]> values;
    std::size_t capacity = 0;
  };
  /// Numbers in a block that is kept, at most: 16 MB, as of two outlines of 250 samples.
  static constexpr std::size_t kMostKept = std::size_t{1} << 21;

  /// A match has two of them: costs, and invalid lengths.
  static std::array<Block, 2>& kept_blocks() {
    thread_local std::array<Block, 2> blocks;
    return blocks;
  }
  /// The smaller ones of it and those that are kept make room.
  void give_back() noexcept {
    if (block_.capacity <= kMostKept) {
      for (Block& kept : kept_blocks()) {
        if (kept.capacity < block_.capacity) std::swap(block_, kept);
      }
    }
    block_ = {};
  }

  Block block_;
  std::size_t size_ = 0;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
