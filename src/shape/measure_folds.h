#pragma once

#include <cstddef>
#include <vector>

#include "shape/flattening.h"

namespace tandem {
inline namespace v0 {

/// Where an edge crosses a scanline, and whether upwards (1) or downwards (-1).
struct ScanCrossing {
  double x = 0.0;
  int direction = 0;
};

/// Scanlines, one after the other.
struct ScanRows {
  std::vector<ScanCrossing> crossings;
  std::vector<std::size_t> ends;          ///< of the rows
  std::vector<std::size_t> above_vertex;  ///< the first row at each vertex or above
};

/// CrossingFinder::fold_fraction of what is flattened. `rows` is memory to work in.
[[nodiscard]] double measure_folds(const Flattening& flat, ScanRows& rows);

}  // namespace v0
}  // namespace tandem
