#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shape/flattening.h"

namespace tandem {
inline namespace v0 {

/// Edges [first, last) of a path, numbered from its start, along which neither coordinate turns: the run
/// cannot cross itself, and its end points span its box.
struct MonotoneRun {
  double lo_x = 0.0, hi_x = 0.0, lo_y = 0.0, hi_y = 0.0;
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Replaces `runs` by those of a path, of eight edges at most, sorted by lo_x. vertices: of the path
void gather_runs(std::span<const FlatVertex> vertices, std::vector<MonotoneRun>& runs);

}  // namespace v0
}  // namespace tandem
