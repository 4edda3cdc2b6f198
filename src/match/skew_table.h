#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "match/aligned_array.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Node costs as the three-step kernels read them. The grid is unrolled in its rows; element j of row e is
/// the cost of node ((e - j) mod rows, j), so that the nodes of an antidiagonal i + j = d lie side by side in
/// row d mod rows.
///
/// V is double, or std::int32_t for costs in fixed point. Costs are >= 0 and below kUnreachable<V>.
template <class V>
class SkewTable {
 public:
  /// Room for `rows` x `width` costs, all zero. A closed table holds column 0 again as its last column.
  SkewTable(std::size_t rows, std::size_t width)
      : rows_(rows),
        width_(width),
        stride_((width + 2 * kLine - 1) / kLine * kLine),
        costs_(rows * stride_, V{0}) {}

  [[nodiscard]] int rows() const noexcept { return static_cast<int>(rows_); }
  [[nodiscard]] int width() const noexcept { return static_cast<int>(width_); }
  [[nodiscard]] std::size_t stride() const noexcept { return stride_; }
  /// Nodes of the antidiagonals d = e (mod rows), by column.
  [[nodiscard]] V* diagonal(std::size_t e) noexcept { return costs_.data() + e * stride_; }
  [[nodiscard]] const V* diagonal(std::size_t e) const noexcept { return costs_.data() + e * stride_; }
  [[nodiscard]] V& at(std::size_t i, std::size_t j) noexcept { return diagonal((i + j) % rows_)[j]; }
  /// Row i, piece by piece: fill(first, n, out, stride) writes n columns from `first` on to every stride-th
  /// place from `out` on.
  template <class Fill>
  void set_row(std::size_t i, const Fill& fill) {
    for (std::size_t j = 0; j < width_;) {
      const std::size_t e = (i + j) % rows_;
      const std::size_t n = std::min(width_ - j, rows_ - e);
      fill(j, n, diagonal(e) + j, stride_ + 1);
      j += n;
    }
  }
  [[nodiscard]] V at(std::size_t i, std::size_t j) const noexcept { return diagonal((i + j) % rows_)[j]; }

 private:
  /// Rows begin at multiples of 64 bytes, and a kernel may read so far past their ends.
  static constexpr std::size_t kLine = 64 / sizeof(V);

  std::size_t rows_;
  std::size_t width_;
  std::size_t stride_;
  AlignedArray<V> costs_;
};

/// What a node costs that no path reaches. Fixed point: sums below this do not overflow when one more cost is
/// added.
template <class V>
inline constexpr V kUnreachable = std::numeric_limits<V>::infinity();
template <>
inline constexpr std::int32_t kUnreachable<std::int32_t> = std::int32_t{1} << 30;

}  // namespace detail
}  // namespace v0
}  // namespace tandem
