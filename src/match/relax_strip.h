#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "match/lexicographic.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Where a cell's path comes from.
enum Move : std::uint8_t { kDiagonal, kLeft, kUp };

[[nodiscard]] constexpr double infinite_like(double) noexcept {
  return std::numeric_limits<double>::infinity();
}
[[nodiscard]] constexpr LexCost infinite_like(LexCost) noexcept {
  return LexCost::infinite();
}

template <class Join>
[[nodiscard]] constexpr double extend(double path, double node) noexcept {
  return Join::join(path, node);
}
template <class Join>
[[nodiscard]] constexpr LexCost extend(LexCost path, LexCost node) noexcept {
  return {path.invalid + node.invalid, Join::join(path.cost, node.cost)};
}

/// The best of three predecessors, and which it is. Ties: diagonal, left, up.
template <class V>
struct Chosen {
  V best;
  std::uint8_t move;
};
[[nodiscard]] inline Chosen<LexCost> choose(LexCost diagonal, LexCost left, LexCost up) noexcept {
  const bool takes_left = left < diagonal;
  const LexCost nearer = takes_left ? left : diagonal;
  if (up < nearer) return {up, kUp};
  return {nearer, takes_left ? kLeft : kDiagonal};
}
/// Without branches: which of the three wins is as good as random.
[[nodiscard]] inline Chosen<double> choose(double diagonal, double left, double up) noexcept {
  const double nearer = left < diagonal ? left : diagonal;
  const double best = up < nearer ? up : nearer;
  const unsigned not_diagonal = best < diagonal;
  const unsigned not_left = best < left;
  return {best, static_cast<std::uint8_t>(not_diagonal + (not_diagonal & not_left))};
}

/// Rows that one strip advances together.
inline constexpr std::size_t kStripRows = 4;

/// Runs [C] eq. (7) over kStripRows rows at once, each one column behind the row above it: a row alone waits
/// for the sum before it at every cell, four of them wait together. Ties: diagonal, left, up.
///
/// nodes: kStripRows rows of `cols` node costs; above: the row before the strip, replaced by the strip's last
/// row; before: the cell left of it (finite only before the first node of all); moves: kStripRows rows of
/// `cols`. Rows from `rows` on are not used. V is double (costs alone) or LexCost.
template <class Join, class V>
void relax_strip(const std::array<const V*, kStripRows>& nodes, std::size_t rows, std::size_t cols,
                 std::vector<V>& above, V before, std::uint8_t* moves) {
  const V none = infinite_like(V{});
  std::array<V, kStripRows> last;
  std::array<V, kStripRows> previous;
  last.fill(none);
  previous.fill(none);
  // Row 0 has read a column of `above` before the strip's last row writes it.
  V above_before = before;
  const auto cell = [&](std::size_t r, std::size_t j) {
    const V up = r > 0 ? last[r - 1] : above[j];
    const V diagonal = r > 0 ? previous[r - 1] : above_before;
    if (r == 0) above_before = up;
    const V left = last[r];
    const Chosen<V> chosen = choose(diagonal, left, up);
    moves[r * cols + j] = chosen.move;
    previous[r] = last[r];
    last[r] = extend<Join>(chosen.best, nodes[r][j]);
  };
  const std::size_t steps = cols + rows - 1;
  for (std::size_t step = 0; step < steps; ++step) {
    if (rows == kStripRows && step >= kStripRows && step < cols) {
      for (std::size_t r = kStripRows; r-- > 0;) cell(r, step - r);
      above[step + 1 - kStripRows] = last[kStripRows - 1];
      continue;
    }
    for (std::size_t r = rows; r-- > 0;) {
      if (step >= r && step - r < cols) cell(r, step - r);
    }
    if (step + 1 >= rows) above[step + 1 - rows] = last[rows - 1];
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
