#pragma once

#include <cstddef>

#include "tandem/shape/path_view.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {

/// Directions of a path before and after a joint, of any length; (0, 0) where there is none, at the ends of
/// an open path.
struct JointTangents {
  Vec2 in;
  Vec2 out;
};

/// Joint `joint` in [0, segment_count); see tangent_breaks.
[[nodiscard]] JointTangents joint_tangents(const PathView& path, std::size_t joint);

/// Grows with the angle between the two, from 0 to 2 at pi; exact about 0, unlike the cosine. 0 where one of
/// them is (0, 0).
[[nodiscard]] double break_size(const JointTangents& tangents);

/// The angle, in radians, that has this size.
[[nodiscard]] double break_angle(double size);

}  // namespace v0
}  // namespace tandem
