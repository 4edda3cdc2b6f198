#pragma once

#include "tandem/curve/points.h"
#include "tandem/match/rotation.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// The frame in which a blend of two keys is made (spec C11): it turns evenly by the rotation of their match
/// while its origin moves in a straight line from one key's centre to the other's. Seen in it, the second key
/// is turned back onto the first, so that a key and its own turned copy blend as a rigid motion.
class TANDEM_EXPORT MovingFrame {
 public:
  /// A frame that stands still: blends are made where the keys lie.
  explicit MovingFrame(int dim);
  /// rotation: the turn from the first key to the second. @throws InvalidArgument the dimensions differ
  MovingFrame(Point first_center, Point second_center, Rotation rotation);

  [[nodiscard]] bool stands_still() const noexcept { return still_; }
  [[nodiscard]] const Point& first_center() const noexcept { return first_center_; }
  [[nodiscard]] const Point& second_center() const noexcept { return second_center_; }
  [[nodiscard]] const Rotation& rotation() const noexcept { return rotation_; }

  /// Points of the first and of the second key, as seen in the frame.
  [[nodiscard]] Points from_first(Points points) const;
  [[nodiscard]] Points from_second(Points points) const;
  /// Points seen in the frame, where they are at s; any finite s.
  [[nodiscard]] Points place(Points points, double s) const;

 private:
  Point first_center_;
  Point second_center_;
  Rotation rotation_;
  bool still_;
};

/// (1 - s) a + s b in the frame: a's points at s = 0, b's at s = 1, up to rounding. a and b: of one size.
[[nodiscard]] TANDEM_EXPORT Points affine_blend(const MovingFrame& frame, const Points& a, const Points& b,
                                                double s);

}  // namespace v0
}  // namespace tandem
