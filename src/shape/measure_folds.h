#pragma once

#include <vector>

#include "shape/flattening.h"

namespace tandem {
inline namespace v0 {

/// Where an edge crosses a scanline, and whether upwards (1) or downwards (-1).
struct ScanCrossing {
  double x = 0.0;
  int direction = 0;
};

/// CrossingFinder::fold_fraction of what is flattened. `rows` is memory to work in.
[[nodiscard]] double measure_folds(const Flattening& flat, std::vector<std::vector<ScanCrossing>>& rows);

}  // namespace v0
}  // namespace tandem
