#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "tandem/progress.h"
#include "tandem/rank/compare.h"
#include "tandem/rank/shape_descriptor.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// A block of the matrix of costs: rows [row, row_end) against columns [column, column_end), of which only
/// the pairs with row < column are compared. On the diagonal both ranges are the same.
struct PairTile {
  std::size_t row = 0;
  std::size_t row_end = 0;
  std::size_t column = 0;
  std::size_t column_end = 0;

  [[nodiscard]] bool is_diagonal() const noexcept { return row == column; }
  /// How many pairs it holds.
  [[nodiscard]] std::size_t pairs() const noexcept {
    const std::size_t rows = row_end - row;
    return is_diagonal() ? rows * (rows - (rows > 0 ? 1 : 0)) / 2 : rows * (column_end - column);
  }
  friend bool operator==(const PairTile&, const PairTile&) = default;
};

/// The pairs of n shapes, cut into tiles. Depends on n alone, so that a run can be taken up again with other
/// threads, and on other machines.
class TANDEM_EXPORT PairTiles {
 public:
  explicit PairTiles(std::size_t shapes) noexcept;

  [[nodiscard]] std::size_t shapes() const noexcept { return shapes_; }
  /// Number of tiles.
  [[nodiscard]] std::size_t size() const noexcept { return blocks_ * (blocks_ + 1) / 2; }
  /// Number of rows of tiles. Every row of tiles has `side()` rows of the matrix, the last one perhaps fewer.
  [[nodiscard]] std::size_t blocks() const noexcept { return blocks_; }
  [[nodiscard]] std::size_t side() const noexcept { return side_; }
  /// @throws InvalidArgument index is not below size()
  [[nodiscard]] PairTile tile(std::size_t index) const;
  /// Which tile holds the block (row, column) of blocks. @throws InvalidArgument unless row <= column <
  /// blocks()
  [[nodiscard]] std::size_t index(std::size_t row, std::size_t column) const;

 private:
  std::size_t shapes_;
  std::size_t side_;
  std::size_t blocks_;
};

/// Hands out the index of a tile that is still to be done; nothing: there is no more.
using TileSource = std::function<std::optional<std::size_t>()>;
/// Takes the costs of a tile: row by row, in each row the columns beyond it.
using TileSink = std::function<void(std::size_t tile, std::span<const double> costs)>;

struct AllPairsOptions {
  CompareOptions compare = {};
  int threads = 0;  ///< 0: all; the costs do not depend on it
  /// Asked for every pair, from any of the threads, with the share of all tiles that this call has done.
  Progress progress = {};
};

/// What every shape costs against every other (spec C15f), tile by tile. The costs depend on the two shapes
/// and the options alone.
///
/// compare() is not exactly symmetric where it searches for the turn, so only one of the two orders is
/// computed, and it stands for both: the query is the shape that comes first in an order on content. Shapes
/// in another order thus give the same costs. Two that are not comparable (open against closed, or of another
/// dimension) cost NaN; where nothing fits at all, infinity.
///
/// source and sink are called from the working threads, one call at a time.
/// @returns false when progress said stop: tiles that were begun then are lost
/// @throws InvalidArgument as ShapeComparer, or the source names a tile that does not exist
TANDEM_EXPORT bool all_pairs(std::span<const ShapeDescriptor> shapes, const TileSource& source,
                             const TileSink& sink, const AllPairsOptions& options = {});

/// The whole matrix, symmetric, with zeros on the diagonal.
struct CostMatrix {
  std::size_t size = 0;
  std::vector<double> costs;  ///< size x size, row by row; empty when cancelled
  bool cancelled = false;

  [[nodiscard]] double operator()(std::size_t i, std::size_t j) const { return costs[i * size + j]; }
};

/// All tiles, in memory.
[[nodiscard]] TANDEM_EXPORT CostMatrix all_pairs(std::span<const ShapeDescriptor> shapes,
                                                 const AllPairsOptions& options = {});

/// Tells apart runs whose tiles do not belong together: another corpus (names and labels do not count),
/// another order, other options, another version of the library.
[[nodiscard]] TANDEM_EXPORT std::uint64_t all_pairs_digest(std::span<const ShapeDescriptor> shapes,
                                                           const CompareOptions& options = {});

}  // namespace v0
}  // namespace tandem
