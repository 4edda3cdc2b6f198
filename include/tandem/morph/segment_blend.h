#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "tandem/shape/cubic_path.h"
#include "tandem/tandem_export.h"

/// Blends of two cubic paths that already have the same segments, as match_segments() makes them.
namespace tandem {
inline namespace v0 {

namespace detail {
struct HermitePlan;
}

/// [D] section 3.1: every control point on the straight line from its place in `a` to its place in `b`; any
/// finite s. Smooth joints do not stay smooth.
/// @throws InvalidArgument the paths differ in dimension, in number of segments, or in being closed
[[nodiscard]] TANDEM_EXPORT CubicPath bezier_blend(const CubicPath& a, const CubicPath& b, double s);

/// [D] section 3.2: joints on straight lines, end tangents blended in length and direction apart, so that
/// joints that are smooth in both paths stay smooth.
///
/// Where the paper is silent (spec D3): directions that are opposite, or within 12 degrees of it, turn
/// evenly, the two sides of a joint in one plane and sense. A handle of no length takes its direction from
/// the next control point that is elsewhere, a segment of no length from its neighbour. Joints that turn by
/// less than 0.05 rad in both paths count as smooth: in between they turn by no more than in the worse one.
/// A straight line against a straight line (handles at the thirds) stays one, and smooth neighbours follow
/// it; unless it turns and meets another such line smoothly in another ratio of lengths: for the joint to
/// stay smooth, both bend.
class TANDEM_EXPORT HermiteBlend {
 public:
  /// @throws InvalidArgument the paths differ in dimension, in number of segments, or in being closed
  HermiteBlend(const CubicPath& a, const CubicPath& b);

  /// Writes the control points at s, point after point as in Points::data(); a's at s = 0 and b's at s = 1,
  /// up to rounding. Other finite s extrapolate: handles shrink to nothing then, and do not turn over.
  /// Allocates nothing.
  /// @throws InvalidArgument points.size() is not dim() * (3 * segment_count() + 1)
  void at(double s, std::span<double> points) const;
  [[nodiscard]] CubicPath at(double s) const;

  [[nodiscard]] int dim() const noexcept;
  [[nodiscard]] std::size_t segment_count() const noexcept;
  /// Segment i is a straight line run through at constant speed, at every s.
  [[nodiscard]] bool is_straight(std::size_t i) const noexcept;

 private:
  std::shared_ptr<const detail::HermitePlan> plan_;  ///< immutable, so copies may share it
};

}  // namespace v0
}  // namespace tandem
