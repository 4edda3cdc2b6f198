#include "tandem/match/assignment.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// rows <= columns; cost(i, j). The row of each column, `rows` where it has none.
template <class Cost>
std::vector<std::size_t> rows_of_columns(std::size_t rows, std::size_t columns, const Cost& cost) {
  std::vector<std::size_t> row_of(columns, rows);
  std::vector<double> row_price(rows, 0.0);
  std::vector<double> column_price(columns, 0.0);
  for (std::size_t first = 0; first < rows; ++first) {
    // The cheapest way from the new row to each column, alternating between pairs and not yet pairs.
    std::vector<double> distance(columns, kInfinity);
    std::vector<std::size_t> from(columns, columns);  // the column before on that way
    std::vector<bool> done(columns, false);
    std::size_t row = first;
    std::size_t last = columns;
    double so_far = 0.0;
    while (true) {
      std::size_t nearest = columns;
      for (std::size_t j = 0; j < columns; ++j) {
        if (done[j]) continue;
        const double through = so_far + cost(row, j) - row_price[row] - column_price[j];
        if (through < distance[j]) {
          distance[j] = through;
          from[j] = last;
        }
        if (nearest == columns || distance[j] < distance[nearest]) nearest = j;
      }
      done[nearest] = true;
      so_far = distance[nearest];
      last = nearest;
      if (row_of[nearest] == rows) break;
      row = row_of[nearest];
    }
    row_price[first] += so_far;
    for (std::size_t j = 0; j < columns; ++j) {
      if (!done[j] || j == last) continue;
      column_price[j] -= so_far - distance[j];
      row_price[row_of[j]] += so_far - distance[j];
    }
    while (last != columns) {
      const std::size_t before = from[last];
      row_of[last] = before == columns ? first : row_of[before];
      last = before;
    }
  }
  return row_of;
}

}  // namespace

std::vector<std::optional<std::size_t>> assign(std::span<const double> cost, std::size_t rows,
                                               std::size_t columns) {
  if (cost.size() != rows * columns) {
    throw InvalidArgument(fmt::format("assign: {} costs, expected {} x {}", cost.size(), rows, columns));
  }
  for (const double c : cost) {
    if (!std::isfinite(c))
      throw InvalidArgument(fmt::format("assign: a cost is {}, expected a finite one", c));
  }
  std::vector<std::optional<std::size_t>> column_of(rows);
  if (rows <= columns) {
    const auto row_of =
        rows_of_columns(rows, columns, [&](std::size_t i, std::size_t j) { return cost[i * columns + j]; });
    for (std::size_t j = 0; j < columns; ++j) {
      if (row_of[j] < rows) column_of[row_of[j]] = j;
    }
  } else {
    const auto columns_of =
        rows_of_columns(columns, rows, [&](std::size_t j, std::size_t i) { return cost[i * columns + j]; });
    for (std::size_t i = 0; i < rows; ++i) {
      if (columns_of[i] < columns) column_of[i] = columns_of[i];
    }
  }
  return column_of;
}

}  // namespace v0
}  // namespace tandem
