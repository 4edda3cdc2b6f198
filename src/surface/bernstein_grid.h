#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "surface/enclosed_spline.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A polynomial in (s, t) on [0,1]^2 by enclosures of its Bernstein coefficients: it lies between the
/// smallest and the largest, and those at the corners are its values there.
struct BernsteinGrid {
  std::size_t rows = 0;     ///< degree in s, plus 1
  std::size_t columns = 0;  ///< degree in t, plus 1
  Enclosures coefficients;  ///< (i, j) at i * columns + j

  [[nodiscard]] const Enclosure& at(std::size_t i, std::size_t j) const noexcept {
    return coefficients[i * columns + j];
  }
  [[nodiscard]] Enclosure& at(std::size_t i, std::size_t j) noexcept { return coefficients[i * columns + j]; }
};

[[nodiscard]] BernsteinGrid product(const BernsteinGrid& f, const BernsteinGrid& g);
/// Of the same degrees.
[[nodiscard]] BernsteinGrid sum(BernsteinGrid f, const BernsteinGrid& g);
[[nodiscard]] BernsteinGrid difference(BernsteinGrid f, const BernsteinGrid& g);

/// The parts over the halves of s (`along` = 0) or t (1).
[[nodiscard]] std::pair<BernsteinGrid, BernsteinGrid> halves(const BernsteinGrid& f, std::size_t along);

/// f / s, f / (1 - s) (`along` = 0), f / t, f / (1 - t) (1), where f = 0 at that edge was proved.
[[nodiscard]] BernsteinGrid without_zero_at_edge(const BernsteinGrid& f, std::size_t along, bool at_end);

/// How much the coefficients differ along s or t, about.
[[nodiscard]] double variation(const BernsteinGrid& f, std::size_t along) noexcept;

}  // namespace detail
}  // namespace v0
}  // namespace tandem
