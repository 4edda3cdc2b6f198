#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tandem/match/match.h"
#include "tandem/morph/blend.h"
#include "tandem/morph/morph.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/shape.h"
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

/// How the moving frame stands: first turned, then moved. Between two keys all three numbers change evenly.
struct FramePose {
  Vec2 center;
  double degrees = 0.0;  ///< summed up from the first key on; from the first axis to the second
  friend bool operator==(const FramePose&, const FramePose&) = default;
};

/// What became of one contour on the way from a key to the next. Where a solid is cut (MorphOptions::cuts),
/// each of its pieces is a contour of the morph: several have the same `a`, or the same `b`.
struct ContourStep {
  std::optional<std::size_t> a;  ///< which contour of the key it is, or is a piece of; nothing: it is born
  std::optional<std::size_t> b;  ///< of the next key; nothing: it dies on the way
  std::optional<Match> match;    ///< of the two, in the parameters of to_curve() of their cubics
};

/// The way from one key to the next.
struct MorphStep {
  BlendKind blend = BlendKind::affine;  ///< the one used, never automatic
  /// Whether some contour is smoothed, shrinks or steps aside on the way, lest it crosses itself or another.
  bool detour = false;
  std::vector<ContourStep> contours;
};

/// A morph through planar key shapes as compatible cubic paths: what SVG, CSS, Lottie and the HTML player
/// speak. Matching happens once, in the constructor; at(s) only blends. Keys stand where MorphOptions::times
/// says.
///
/// With MorphOptions::smooth the motion has one velocity on both sides of a key: the mean of the velocities
/// of the two steps that meet there, weighted as in a parabola through three keys. On the way from key to key
/// the step's own blend is bent by cubic Hermite functions to meet those, and so is the pose of the frame.
/// Where that would make in-betweens cross or fold that did not, collapse or turn inside out, outlines pass
/// the key at a half or a quarter of that speed, or rest on it (pace()). When the last key is the first one
/// again, with its joints where they were, the two are passed as one.
///
/// The keys are redrawn exactly where they are polynomial of degree <= 3, within `tolerance` of their
/// diagonal otherwise; all with the same segments. ClosedMode::yes closes their open contours by lines.
///
/// A key whose solid is cut into pieces is still that solid: the pieces start where one of them is all of it
/// and the others are parts of its outline, forth and back, which draw nothing else, filled or stroked; on
/// the way the chords come in from there.
class TANDEM_EXPORT PathMorph {
 public:
  /// @throws InvalidArgument fewer than two keys, a key without contours, a dimension other than 2, and as
  /// match()
  explicit PathMorph(std::span<const Shape> keys, const MorphOptions& options = {}, double tolerance = 1e-5);
  PathMorph(PathMorph&&) noexcept;
  PathMorph& operator=(PathMorph&&) noexcept;
  ~PathMorph();

  /// The in-between at s: one path per contour, always with the same segments. Any finite s: beyond the keys
  /// it extrapolates.
  [[nodiscard]] std::vector<CubicPath> at(double s) const;
  /// How many numbers an in-between is: x and y of the control points of all contours, one after the other.
  [[nodiscard]] std::size_t coordinate_count() const noexcept;
  /// The control points of at(s) into the caller's memory, contour after contour: without an allocation, but
  /// for contours of more than 200 segments that are smoothed on the way.
  /// @throws InvalidArgument room for another number than coordinate_count()
  void at(double s, std::span<double> coordinates) const;
  /// The same as the frame sees it: turned back and moved back by pose_at(s).
  [[nodiscard]] std::vector<CubicPath> in_frame(double s) const;
  [[nodiscard]] FramePose pose_at(double s) const;

  /// The keys: in_frame() there.
  [[nodiscard]] const std::vector<PathContour>& contours() const noexcept;
  /// Whether the frame turns; otherwise it stands still at all keys, about (0, 0).
  [[nodiscard]] bool turns() const noexcept;
  /// One per key.
  [[nodiscard]] const std::vector<FramePose>& poses() const noexcept;
  /// The s at which the keys stand.
  [[nodiscard]] const std::vector<double>& key_times() const noexcept;
  /// Whether the motion passes its keys without a break of velocity: as asked for, with three keys or more.
  [[nodiscard]] bool is_smooth() const noexcept;
  /// Of a smooth morph: at which share of its speed each key is passed, 1 wherever nothing crosses for it.
  [[nodiscard]] const std::vector<double>& pace() const noexcept;
  /// Whether in_frame(s) runs straight from key to key, so that the keys and their poses say it all.
  [[nodiscard]] bool is_linear() const noexcept;
  /// One per pair of neighbouring keys; its contours are those of contours().
  [[nodiscard]] const std::vector<MorphStep>& steps() const noexcept;
  [[nodiscard]] std::size_t key_count() const noexcept;
  /// Nonzero, by which the contours are wound; even-odd where a key of that rule has contours that cross.
  [[nodiscard]] FillRule fill_rule() const noexcept;
  /// Box around all keys, and around the in-betweens as far as samples tell.
  [[nodiscard]] const Box& box() const noexcept;
  /// The progress callback said stop: the morph must not be used.
  [[nodiscard]] bool cancelled() const noexcept;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace v0
}  // namespace tandem
