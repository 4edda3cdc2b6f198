#include <fmt/format.h>

#include <algorithm>

#include "tandem/error.h"
#include "tandem/rank/all_pairs.h"

namespace tandem {
inline namespace v0 {

namespace {

/// Large enough that a shape is prepared once for many pairs, and small enough that little is lost when the
/// work is cut off in the middle of a tile.
constexpr std::size_t kLargestSide = 16;
/// So many rows of tiles, where there are shapes enough: work for some hundred threads.
constexpr std::size_t kBlocksWanted = 24;

}  // namespace

PairTiles::PairTiles(std::size_t shapes) noexcept
    : shapes_(shapes),
      side_(std::clamp<std::size_t>(shapes / kBlocksWanted, 1, kLargestSide)),
      blocks_((shapes + side_ - 1) / side_) {}

PairTile PairTiles::tile(std::size_t index) const {
  if (index >= size()) throw InvalidArgument(fmt::format("tile {} of {} does not exist", index, size()));
  std::size_t row = 0;
  for (std::size_t in_row = blocks_; index >= in_row; --in_row, ++row) index -= in_row;
  const auto end = [this](std::size_t block) { return std::min(shapes_, (block + 1) * side_); };
  const std::size_t column = row + index;
  return {row * side_, end(row), column * side_, end(column)};
}

std::size_t PairTiles::index(std::size_t row, std::size_t column) const {
  if (row > column || column >= blocks_) {
    throw InvalidArgument(
        fmt::format("there is no tile in row {} and column {} of {} blocks", row, column, blocks_));
  }
  // Rows of blocks_, blocks_ - 1, ... tiles stand above.
  return row * blocks_ - row * (row + 1) / 2 + column;
}

}  // namespace v0
}  // namespace tandem
