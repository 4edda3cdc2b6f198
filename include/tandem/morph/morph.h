#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "tandem/match/match.h"
#include "tandem/morph/blend.h"
#include "tandem/morph/key_times.h"
#include "tandem/morph/moving_frame.h"
#include "tandem/morph/segment_blend.h"
#include "tandem/shape/shape.h"
#include "tandem/shape/transform.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// A point of the first key and one of the second that belong together: the points of their outlines that are
/// nearest to these.
struct MorphPin {
  Vec2 a;
  Vec2 b;
};

struct MorphOptions {
  /// `rotate` empty: turns are looked for in the tangent norm and in a caller's own; the others say where the
  /// curves lie.
  MatchOptions match = {};
  /// Morph only (PathMorph decides by the in-betweens). The keys blend as they lie unless a turn lowers the
  /// cost of matching them by this share (see common_rotation()): in-betweens should not spin for a trifle.
  /// For a rotation that is given it does not count.
  double least_gain = 0.3;
  /// Empty: the method's own: `paper` affine, `segments` hermite, `elastic` automatic. Morph knows affine
  /// (which automatic is for it), bezier and hermite.
  std::optional<BlendKind> blend = {};
  /// PathMorph of two keys only. The contours of a pin become one another.
  std::vector<MorphPin> pins = {};
  /// PathMorph of two keys without pins, elastic method only: whether one solid against several may be cut
  /// into as many pieces, where the in-betweens are better for it; else, and where both pieces would have
  /// holes, all but one grow from points.
  bool cuts = true;
  /// The s at which the keys stand, one per key, rising from 0 to 1; empty: evenly, key i of n at i / (n -
  /// 1).
  std::vector<double> times = {};
  /// Pass the keys between the first and the last without a break of velocity (spec C15b); see Morph and
  /// PathMorph.
  bool smooth = false;
};

/// A morph through n key shapes: matching happens once, in the constructor; at(s) only blends.
///
/// Affine blend ([C] eq. (1), spec C2, C15a) of the matched contours, which are brought into one function
/// space (common degree, knots and denominator, exact); or the hermite one of [D], in any dimension, of
/// contours that are cubics then. With Method::segments they are redrawn as cubics (exact to degree 3, else
/// within 1e-6 of their size) and cut where match_segments() does, so that every key has its segments. All
/// contours of a key turn together, and the blend is made in the frame that turns with them (MovingFrame).
/// Contours are paired in order; one without a partner grows from, or shrinks to, its own centre. Keys stand
/// where MorphOptions::times says. Under the nonzero fill rule, which tells holes by their direction, the
/// closed contours of a key are all matched forward or all reversed.
///
/// With MorphOptions::smooth control points pass the keys between the first and the last at the velocity of
/// the parabola through three keys, on cubic Hermite curves; seen from where they are drawn, so that a body
/// that turns unevenly is up to some percent larger on the way.
class TANDEM_EXPORT Morph {
 public:
  /// Matches each shape with the next (spec C14). @throws InvalidArgument fewer than two keys, a key without
  /// contours, different dimensions, a blend that Morph does not know, or the hermite one of contours of a
  /// degree above 3 or with weights, and as match()
  explicit Morph(std::span<const Shape> keys, const MorphOptions& options = {});
  /// The morph of two curves that are already matched, with the match's rotation.
  Morph(const Curve& a, const Curve& b, const Match& match);
  /// The morph of curves that are in step already: over one domain, at one parameter all at one moment.
  /// Nothing is matched, so of the options only `times` and `smooth` count.
  /// @throws InvalidArgument fewer than two curves, different dimensions or domains
  [[nodiscard]] static Morph in_step(std::span<const Curve> curves, const MorphOptions& options = {});

  /// The in-between at s. s < 0 and s > 1 extrapolate along the first and the last pair of keys.
  [[nodiscard]] Shape at(double s) const;

  [[nodiscard]] std::size_t key_count() const noexcept { return key_count_; }
  /// Even-odd when any key's is, else nonzero.
  [[nodiscard]] FillRule fill_rule() const noexcept { return fill_rule_; }
  [[nodiscard]] std::size_t contour_count() const noexcept { return contours_.size(); }
  /// The compatible curves of one contour, one per key, over one domain.
  [[nodiscard]] std::span<const Curve> keys(std::size_t contour) const noexcept { return contours_[contour]; }
  /// The s at which the keys stand.
  [[nodiscard]] const std::vector<double>& key_times() const noexcept { return times_; }
  /// Whether it passes its keys without a break of velocity: as asked for, with three keys or more.
  [[nodiscard]] bool is_smooth() const noexcept { return !bends_.empty(); }
  /// The frame of the blend from key `key` to key + 1.
  [[nodiscard]] const MovingFrame& frame(std::size_t key) const noexcept { return frames_[key]; }
  /// The match of key `key` with key + 1 in `contour`; nothing where a contour has no partner.
  [[nodiscard]] const std::optional<Match>& match(std::size_t key, std::size_t contour) const {
    return matches_[key][contour];
  }
  /// The progress callback said stop: the morph must not be used.
  [[nodiscard]] bool cancelled() const noexcept { return cancelled_; }

 private:
  Morph() = default;
  void blend_by_hermite();
  void bend_steps();
  /// Control points of a contour on the way of a step, without bends.
  [[nodiscard]] Points step_points(std::size_t step, std::size_t contour, double local) const;

  /// What a smooth morph adds to the velocities of a step's control points at its ends, per step.
  struct Bend {
    Points start;
    Points end;
  };
  std::size_t key_count_ = 0;
  std::vector<double> times_ = {0.0, 1.0};
  FillRule fill_rule_ = FillRule::nonzero;
  bool cancelled_ = false;
  std::vector<std::vector<Curve>> contours_;                ///< [contour][key]
  std::vector<std::vector<Bend>> bends_;                    ///< [contour][step]; empty: not smooth
  std::vector<MovingFrame> frames_;                         ///< key_count - 1
  std::vector<std::vector<std::optional<Match>>> matches_;  ///< [key][contour], key_count - 1 rows
  std::vector<std::vector<HermiteBlend>> hermite_;          ///< the same, as the frames see them; or none
};

}  // namespace v0
}  // namespace tandem
