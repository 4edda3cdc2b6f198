#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "match/fixed_costs.h"
#include "tandem/rank/compare.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The directions of a planar shape's tangents, in bins, and how far every direction is from the nearest of
/// them: enough to bound from below what matching it with another shape costs, whatever the path, the start
/// and the turn.
///
/// A path visits every node of either shape, and a node (i,j) costs at least what tangent i costs with the
/// nearest tangent of the other shape, wherever that is. Summed over the nodes of one shape ("rows") and of
/// the other ("columns"):
///   symmetric: a diagonal step counts twice, once for the row and once for the column that it enters, any
///              other once for the one that it enters: rows + columns + charge * |m1 - m2| <= the sum;
///   paper:     every row and every column is entered at least once: max(rows, columns) <= the sum;
///   elastic:   half of the integral runs over either length: (rows + columns) / 2, weighted by length.
/// Bins make the distance of two directions uncertain by one bin, an unknown turn by half a bin more; both
/// are taken off.
class DirectionBound {
 public:
  DirectionBound() = default;
  /// tangents: planar, m; weights: of the nodes in the sum, m.
  DirectionBound(const TangentPlanes& tangents, std::span<const double> weights);

  /// No comparison of a with b under these options (mirrored and reversed already) costs less, per unit of
  /// path.
  [[nodiscard]] static double lower_bound(const DirectionBound& a, const DirectionBound& b,
                                          const CompareOptions& options);

 private:
  static constexpr std::size_t kBins = 128;
  using Bins = std::array<double, kBins>;

  Bins weight_{};
  Bins nearest_fixed_{};   ///< least cost of a direction in this bin
  Bins nearest_turned_{};  ///< the same when the turn is known to half a bin only
  double nodes_ = 0.0;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
