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
  /// The shape in kStretches chords of one length, for the search of turns; empty without one.
  TangentPlanes coarse;
  std::vector<double> coarse_lengths;
  DirectionBound bound;  ///< planar shapes only
};

/// Enough to tell turns apart; the best one is improved afterwards with all chords.
inline constexpr int kStretches = 32;

/// The weights of the nodes in the sums that the bound is about.
[[nodiscard]] std::vector<double> node_weights(const std::vector<double>& lengths,
                                               const CompareOptions& options);

[[nodiscard]] Variant make_variant(const ShapeDescriptor& shape, bool mirrored, bool reversed,
                                   const CompareOptions& options);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
