#pragma once

#include <cstddef>
#include <span>

#include "match/segment_runs.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The integral of |C'(t)|^2 over [0, 1] of a cubic, from its control differences: 3 * dim numbers.
[[nodiscard]] double derivative_energy(std::span<const double> differences, std::size_t dim);

/// What it costs to let segment `i` of `one` meet segments first, .. first + count - 1 of `run`, by the
/// definition, piece by piece. Sums up no further once the cost is above `most`.
[[nodiscard]] double cost_by_pieces(const SegmentVectors& one, std::size_t i, const SegmentVectors& run,
                                    std::size_t first, std::size_t count, SegmentCost cost, double most);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
