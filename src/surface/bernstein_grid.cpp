#include "surface/bernstein_grid.h"

#include <cmath>

#include "surface/bernstein_enclosure.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

Enclosures line(const BernsteinGrid& f, std::size_t along, std::size_t index) {
  Enclosures result(along == 0 ? f.rows : f.columns);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = along == 0 ? f.at(k, index) : f.at(index, k);
  return result;
}

void set_line(BernsteinGrid& f, std::size_t along, std::size_t index, const Enclosures& values) {
  for (std::size_t k = 0; k < values.size(); ++k) (along == 0 ? f.at(k, index) : f.at(index, k)) = values[k];
}

BernsteinGrid grid(std::size_t rows, std::size_t columns) {
  return {rows, columns, Enclosures(rows * columns)};
}

// Coefficients times their binomials: products of such are sums of products.
BernsteinGrid weighed(BernsteinGrid f) {
  const Enclosures& of_rows = binomial_row(f.rows - 1);
  const Enclosures& of_columns = binomial_row(f.columns - 1);
  for (std::size_t i = 0; i < f.rows; ++i) {
    for (std::size_t j = 0; j < f.columns; ++j) {
      if (i != 0 && i + 1 != f.rows) f.at(i, j) = f.at(i, j) * of_rows[i];
      if (j != 0 && j + 1 != f.columns) f.at(i, j) = f.at(i, j) * of_columns[j];
    }
  }
  return f;
}

}  // namespace

BernsteinGrid product(const BernsteinGrid& f, const BernsteinGrid& g) {
  const BernsteinGrid x = weighed(f);
  const BernsteinGrid y = weighed(g);
  BernsteinGrid result = grid(f.rows + g.rows - 1, f.columns + g.columns - 1);
  for (std::size_t i = 0; i < x.rows; ++i) {
    for (std::size_t j = 0; j < x.columns; ++j) {
      const Enclosure factor = x.at(i, j);
      if (factor.is_zero()) continue;
      for (std::size_t k = 0; k < y.rows; ++k) {
        for (std::size_t l = 0; l < y.columns; ++l) result.at(i + k, j + l) += factor * y.at(k, l);
      }
    }
  }
  const Enclosures& of_rows = binomial_row(result.rows - 1);
  const Enclosures& of_columns = binomial_row(result.columns - 1);
  for (std::size_t i = 0; i < result.rows; ++i) {
    for (std::size_t j = 0; j < result.columns; ++j) {
      if (i != 0 && i + 1 != result.rows) result.at(i, j) = result.at(i, j) / of_rows[i];
      if (j != 0 && j + 1 != result.columns) result.at(i, j) = result.at(i, j) / of_columns[j];
    }
  }
  return result;
}

BernsteinGrid sum(BernsteinGrid f, const BernsteinGrid& g) {
  f.coefficients = sum(std::move(f.coefficients), g.coefficients);
  return f;
}

BernsteinGrid difference(BernsteinGrid f, const BernsteinGrid& g) {
  f.coefficients = difference(std::move(f.coefficients), g.coefficients);
  return f;
}

std::pair<BernsteinGrid, BernsteinGrid> halves(const BernsteinGrid& f, std::size_t along) {
  std::pair<BernsteinGrid, BernsteinGrid> result = {f, f};
  for (std::size_t k = 0; k < (along == 0 ? f.columns : f.rows); ++k) {
    const auto [low, high] = halves(line(f, along, k));
    set_line(result.first, along, k, low);
    set_line(result.second, along, k, high);
  }
  return result;
}

BernsteinGrid without_zero_at_edge(const BernsteinGrid& f, std::size_t along, bool at_end) {
  BernsteinGrid result = grid(along == 0 ? f.rows - 1 : f.rows, along == 0 ? f.columns : f.columns - 1);
  for (std::size_t k = 0; k < (along == 0 ? f.columns : f.rows); ++k) {
    const Enclosures whole = line(f, along, k);
    set_line(result, along, k, at_end ? without_zero_at_1(whole) : without_zero_at_0(whole));
  }
  return result;
}

double variation(const BernsteinGrid& f, std::size_t along) noexcept {
  double total = 0.0;
  for (std::size_t i = along == 0 ? 1 : 0; i < f.rows; ++i) {
    for (std::size_t j = along == 0 ? 0 : 1; j < f.columns; ++j) {
      const Enclosure& before = along == 0 ? f.at(i - 1, j) : f.at(i, j - 1);
      total += std::abs(f.at(i, j).middle() - before.middle());
    }
  }
  return total;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
