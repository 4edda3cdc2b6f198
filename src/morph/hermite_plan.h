#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/curve/points.h"
#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A direction that turns in a plane, from the unit vector w at s = 0 by `degrees` towards the unit vector t,
/// orthogonal to w, until s = 1.
struct Turn {
  double weights[2] = {1.0, 1.0};  ///< how much the directions at the two ends count
  double cosine = 1.0;             ///< of the whole angle
  double sine = 0.0;
  double degrees = 0.0;
  bool even = false;  ///< at constant speed; else as the weighted mean of the two directions does
};

/// The handle at one end of a segment: its length at both ends of time, and its direction as seen in the
/// frame of a turn: so much along it, so much beside it, and a rest that is orthogonal to the turn's plane.
struct Handle {
  std::size_t turn = 0;
  double lengths[2] = {0.0, 0.0};
  double along[2] = {1.0, 1.0};
  double beside[2] = {0.0, 0.0};
};

/// What HermiteBlend knows of its two paths.
struct HermitePlan {
  Points a;
  Points b;
  bool closed = false;
  std::vector<char> straight;  ///< per segment
  std::vector<Turn> turns;
  Points turn_w;                ///< per turn
  Points turn_t;                ///< per turn
  std::vector<Handle> handles;  ///< per segment: at its start, at its end; meaningless where straight
  Points rests;                 ///< per handle: of a, of b

  /// The handle, as a vector in the direction in which the segment runs.
  void handle_at(std::size_t handle, double s, std::span<double> out) const;
};

/// The paths must have the same segments.
[[nodiscard]] HermitePlan plan_hermite_blend(const CubicPath& a, const CubicPath& b);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
