#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tandem {
inline namespace v0 {

/// A rows x cols table of costs with a validity flag each; row by row.
struct NodeTable {
  std::size_t rows = 0;
  std::size_t cols = 0;
  std::vector<double> cost;           ///< rows * cols
  std::vector<std::uint8_t> invalid;  ///< rows * cols, 0 or 1

  [[nodiscard]] std::size_t index(std::size_t i, std::size_t j) const noexcept { return i * cols + j; }
};

/// One step of the elastic programme: `a` chords of the first curve against `b` of the second.
struct Step {
  int a = 1;
  int b = 1;
  friend bool operator==(const Step&, const Step&) = default;
};

/// A node of a path: sample i of the first curve, sample j of the second. On closed curves both may run on
/// past the last sample instead of wrapping.
struct Node {
  int i = 0;
  int j = 0;
  friend bool operator==(const Node&, const Node&) = default;
};

}  // namespace v0
}  // namespace tandem
