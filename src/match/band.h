#pragma once

#include <vector>

#include "tandem/match/cost_table.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The nodes that a programme may visit beside a path that is known roughly: a range of columns for every row
/// of the grid unrolled in both directions.
struct Band {
  struct Range {
    int lo = 0;
    int hi = -1;  ///< the last one
  };
  /// May be negative. Where rows are cyclic, paths start in the first rows and end as many rows below them as
  /// the loop has.
  int first_row = 0;
  std::vector<Range>
      columns;  ///< of rows first_row, first_row + 1, ..; paths start at column 0 or a little on
};

/// The two curves of a programme, as it sees them.
struct Grid {
  const Samples& rows;
  const Samples& cols;
};

/// The nodes within `radius` samples of the path that a programme on fewer samples of the same curves found,
/// in rows and in columns. first_cols: paths start in that many columns.
[[nodiscard]] Band band_near(const Grid& fine, const Grid& coarse, const std::vector<Node>& path, int radius,
                             int first_cols);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
