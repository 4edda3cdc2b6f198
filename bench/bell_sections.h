#pragma once

#include <cstddef>
#include <vector>

#include "tandem/curve/curve.h"

namespace tandem::bench {

/// Cubic sections in planes z = 0, 1, ..., of `n` control points each, with a bell each: every section has
/// its own shape, seam and speed. The same ones every time.
[[nodiscard]] std::vector<Curve> bell_sections(std::size_t count, std::size_t n, bool closed);

}  // namespace tandem::bench
