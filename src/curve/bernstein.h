#pragma once

#include <cstddef>
#include <vector>

namespace tandem {
inline namespace v0 {
namespace detail {

/// The binomial coefficients of degree n. Exact up to n = 56; finite up to n = kLargestProductDegree.
[[nodiscard]] inline std::vector<double> binomials(int n) {
  std::vector<double> row(static_cast<std::size_t>(n) + 1, 1.0);
  for (std::size_t k = 1; k < row.size(); ++k) {
    const std::size_t from_right = row.size() - 1 - k;
    row[k] = k <= from_right + 1 ? row[k - 1] * static_cast<double>(row.size() - k) / static_cast<double>(k)
                                 : row[from_right];
  }
  return row;
}

/// Above this degree the middle binomial coefficients no longer fit into a double.
inline constexpr int kLargestProductDegree = 1000;

}  // namespace detail
}  // namespace v0
}  // namespace tandem
