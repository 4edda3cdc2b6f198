#pragma once

#include <vector>

#include "match/fixed_costs.h"
#include "rank/direction_bound.h"
#include "tandem/rank/compare.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A shape as it is, mirrored, run through backwards, or both, with what comparing needs of it.
struct Variant {
  bool mirrored = false;
  bool reversed = false;
  TangentPlanes tangents;       ///< m
  std::vector<double> lengths;  ///< m, sum 1
  /// Mean tangents over equally long stretches, coordinate by coordinate: dim planes of kStretches each.
  std::vector<double> stretches;
  DirectionBound bound;  ///< planar shapes only
};

/// Enough to tell turns apart; they are improved afterwards.
inline constexpr int kStretches = 64;

/// The weights of the nodes in the sums that the bound is about.
[[nodiscard]] std::vector<double> node_weights(const std::vector<double>& lengths,
                                               const CompareOptions& options);

[[nodiscard]] Variant make_variant(const ShapeDescriptor& shape, bool mirrored, bool reversed,
                                   const CompareOptions& options);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
