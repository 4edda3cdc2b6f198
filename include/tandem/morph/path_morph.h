#pragma once

#include <cstddef>
#include <vector>

#include "tandem/morph/morph.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/transform.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// One contour of a planar morph as cubics: every key has the same segments, so that blending is point by
/// point. Where the morph turns (PathMorph::turns()), the keys are as the moving frame sees them: each about
/// its centre, and turned back by its pose.
struct PathContour {
  std::vector<CubicPath> keys;
  std::vector<bool> lines;  ///< per segment: a straight line in every key, and so in every in-between
};

/// How the moving frame stands at a key: first turned, then moved. Between two keys all three numbers change
/// evenly, so the in-between is the linear blend of the keys, turned by the angle and moved to the centre.
struct FramePose {
  Vec2 center;
  double degrees = 0.0;  ///< summed up from the first key on; from the first axis to the second
  friend bool operator==(const FramePose&, const FramePose&) = default;
};

/// A planar morph redrawn as compatible cubic paths: what SVG, CSS, Lottie and the HTML player speak.
///
/// Exact for polynomial contours of degree <= 3; others are approximated, all keys with the same breaks,
/// within `tolerance` times the diagonal of the keys.
class TANDEM_EXPORT PathMorph {
 public:
  /// @throws InvalidArgument the morph is not planar
  explicit PathMorph(const Morph& morph, double tolerance = 1e-5);

  /// The in-between at s: one path per contour, always with the same number of segments.
  [[nodiscard]] std::vector<CubicPath> at(double s) const;
  [[nodiscard]] const std::vector<PathContour>& contours() const noexcept { return contours_; }
  /// Whether the frame turns; otherwise it stands still at all keys, about (0, 0).
  [[nodiscard]] bool turns() const noexcept { return turns_; }
  /// One per key.
  [[nodiscard]] const std::vector<FramePose>& poses() const noexcept { return poses_; }
  [[nodiscard]] std::size_t key_count() const noexcept { return key_count_; }
  [[nodiscard]] FillRule fill_rule() const noexcept { return fill_rule_; }
  /// Box around all keys; around the in-betweens as well (as far as samples tell) where the frame turns.
  [[nodiscard]] const Box& box() const noexcept { return box_; }

 private:
  void enter_frame();

  std::size_t key_count_ = 0;
  FillRule fill_rule_ = FillRule::nonzero;
  std::vector<PathContour> contours_;
  std::vector<FramePose> poses_;
  bool turns_ = false;
  Box box_;
};

}  // namespace v0
}  // namespace tandem
