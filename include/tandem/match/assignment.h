#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// The column of each row in an assignment of least total cost, in which min(rows, columns) pairs are made;
/// nothing for a row that is left over. cost: row by row, rows * columns finite numbers.
///
/// Shortest augmenting paths (Jonker and Volgenant 1987): O(n^2 m) for n <= m.
/// @throws InvalidArgument the sizes disagree, or a cost is not finite
[[nodiscard]] TANDEM_EXPORT std::vector<std::optional<std::size_t>> assign(std::span<const double> cost,
                                                                           std::size_t rows,
                                                                           std::size_t columns);

}  // namespace v0
}  // namespace tandem
