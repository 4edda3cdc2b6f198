#pragma once

#include <cstdint>
#include <vector>

#include "match/skew_table.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Node costs in fixed point: whole multiples of a quantum, so that sums are exact and every instruction set
/// gives the same bits. The programmes are exact for these costs; a path of n nodes that is optimal for them
/// is at most n * quantum worse than the optimum of the costs they stand for (half a quantum per node, on
/// both paths).
struct FixedCosts {
  SkewTable<std::int32_t> table;
  double quantum = 1.0;
};

/// Unit vectors along a curve, one plane of coordinates per dimension.
struct TangentPlanes {
  std::vector<std::vector<double>> planes;

  [[nodiscard]] std::size_t size() const { return planes.empty() ? 0 : planes.front().size(); }
};

/// The finest quantum with which no path through rows x cols nodes overflows, if a node costs at most `most`:
/// a power of two.
[[nodiscard]] double fixed_quantum(std::size_t rows, std::size_t cols, double most);

/// Costs 1 - <T1,T2> of all pairs of nodes. cyclic: as loops, column 0 once more at the end.
/// `weight`: what a step may multiply a node's cost with (2: StepRule::double_diagonal).
[[nodiscard]] FixedCosts fixed_tangent_costs(const TangentPlanes& a, const TangentPlanes& b, bool cyclic,
                                             double weight = 1.0);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
