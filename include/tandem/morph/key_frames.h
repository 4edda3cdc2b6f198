#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "tandem/curve/bounding_box.h"
#include "tandem/morph/path_morph.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/shape.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// A morph as frames that are blended point by point, evenly in s, from each to the next: all that file
/// formats hold. The frames are the keys of the morph, and as many in-betweens as a blend needs that is not
/// linear.
struct TANDEM_EXPORT KeyFrames {
  std::vector<double> times;                  ///< s of each frame, ascending, from 0 to 1
  std::vector<std::size_t> keys;              ///< which of the frames are the keys of the morph
  std::vector<std::vector<CubicPath>> paths;  ///< [frame][contour], the same segments in all frames
  std::vector<std::vector<bool>> lines;  ///< [contour][segment]: straight in every frame; empty: not known
  FillRule fill_rule = FillRule::nonzero;
  /// One per frame, when the paths are as the turning frame sees them; empty when they lie where they are
  /// drawn.
  std::vector<FramePose> poses;
  /// The motion passes the keys without a break of velocity: one easing may time it from end to end.
  bool smooth = false;
  Box box;  ///< around all in-betweens, where they are drawn
  /// How far control points of the linear blends are from those of the motion at most, as a share of the
  /// diagonal of `box` (with poses: plus how far these carry them off): the largest that was found at seven
  /// places between any two frames.
  double max_error = 0.0;
};

/// A motion: the contours at s in [0,1], always with the same segments.
using Motion = std::function<std::vector<CubicPath>(double s)>;

struct KeyFrameOptions {
  /// Bound of max_error, a share of the diagonal. It is missed where the motion is still not linear between
  /// frames 1/1024 of the way from key to key apart: where it jumps.
  double tolerance = 1e-3;
  /// The paths where they are drawn; otherwise those of a turning morph are as the frame sees them, with
  /// poses, which takes fewer frames.
  bool bake_turn = true;
};

/// Goes from each key to the next in steps as long as linear blends stay within the tolerance.
/// @throws InvalidArgument tolerance <= 0
[[nodiscard]] TANDEM_EXPORT KeyFrames key_frames(const PathMorph& morph, const KeyFrameOptions& options = {});

/// The same for any planar motion; its `lines` are not known.
/// @throws InvalidArgument key_times do not rise from 0 to 1, tolerance <= 0, or the segments change
[[nodiscard]] TANDEM_EXPORT KeyFrames key_frames(const Motion& motion, std::span<const double> key_times,
                                                 const KeyFrameOptions& options = {});

}  // namespace v0
}  // namespace tandem
