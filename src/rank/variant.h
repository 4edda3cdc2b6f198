#pragma once

#include <vector>

#include "rank/direction_bound.h"
#include "tandem/curve/points.h"
#include "tandem/rank/compare.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A shape as it is, mirrored, run through backwards, or both, with what comparing needs of it.
struct Variant {
  bool mirrored = false;
  bool reversed = false;
  Points tangents;              ///< dim x m
  std::vector<double> lengths;  ///< m, sum 1
  /// Mean tangents over equally long stretches, coordinate by coordinate: dim planes of kStretches each.
  std::vector<double> stretches;
  DirectionBound bound;  ///< planar shapes only
};

/// Enough to tell turns apart; they are improved afterwards.
inline constexpr int kStretches = 64;

[[nodiscard]] Variant make_variant(const ShapeDescriptor& shape, bool mirrored, bool reversed,
                                   const CompareOptions& options);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
