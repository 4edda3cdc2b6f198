#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/curve/interval.h"
#include "tandem/curve/points.h"
#include "tandem/match/match.h"
#include "tandem/morph/morph.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

struct MotionOptions {
  /// What is empty or automatic here means for motions: 300 nodes, forward, both ends pinned, as the
  /// coordinates lie (no turn), v by tolerance 1e-3 of order 4, so that time is warped without a break.
  MatchOptions match = {};
  /// What a unit of each coordinate counts in the match; empty: each by its own spread (one by the standard
  /// deviation over time, as the quadratic mean over the motions), so that it does not matter in which units
  /// they are. A coordinate that never changes does not count.
  std::vector<double> weights = {};
  /// What time counts in the match: the whole duration as much as so many standard deviations of a
  /// coordinate. It decides where nothing moves; larger than the length of the motion it would leave time
  /// nearly unwarped.
  double time_weight = 1.0;
  std::vector<double> times = {};  ///< MorphOptions::times
  bool smooth = false;             ///< MorphOptions::smooth
};

/// A morph of motions: curves in R^n whose parameter is time (spec C15g), such as joint angles of a walk and
/// of a run.
///
/// Motions are matched as curves (t, x) in R^(n+1), by their tangents, so what happens in one is put in step
/// with what happens alike in the other, whenever that is. Where values stand still (spec C18), time goes on,
/// and pauses are put in step with pauses where there are some. Then time and values are blended alike: the
/// in-between at s does at the time (1 - s) u + s v(u) what is between A at u and B at v(u); it lasts (1 - s)
/// times as long as A plus s times as long as B.
class TANDEM_EXPORT MotionMorph {
 public:
  /// @throws InvalidArgument fewer than two motions, different dimensions, a rational curve (its time would
  /// not be one of the same knots), other numbers of weights than coordinates, weights or time_weight that
  /// are negative or not finite, time_weight 0 and a motion that does not move; and as match()
  explicit MotionMorph(std::span<const Curve> motions, const MotionOptions& options = {});

  /// The in-between at s as its graph: dim + 1 coordinates, the first one is the time, over the first
  /// motion's domain.
  [[nodiscard]] Curve graph(double s) const;
  /// From when to when the in-between at s lasts.
  [[nodiscard]] Interval duration(double s) const;
  /// (dim + 1) x count: the in-between at s at even times, the time first.
  /// @throws InvalidArgument count < 2; time that runs back, as it may for s beyond [0,1]
  [[nodiscard]] Points rows(double s, std::size_t count) const;

  [[nodiscard]] std::size_t key_count() const noexcept { return morph_.key_count(); }
  [[nodiscard]] const std::vector<double>& key_times() const noexcept { return morph_.key_times(); }
  [[nodiscard]] bool is_smooth() const noexcept { return morph_.is_smooth(); }
  /// Number of coordinates without time.
  [[nodiscard]] int dim() const noexcept { return morph_.keys(0).front().dim() - 1; }
  /// How motion `step` was put in step with motion step + 1: of the weighted graphs that were matched. Its
  /// parameters are the first motion's time (of the first step), and the time of motion step + 1.
  [[nodiscard]] const Match& match(std::size_t step) const { return matches_[step]; }
  /// The progress callback said stop: the morph must not be used.
  [[nodiscard]] bool cancelled() const noexcept { return cancelled_; }

 private:
  std::vector<Match> matches_;
  bool cancelled_ = false;
  Morph morph_;
};

/// A motion as a curve in R^(dim + 1) over the same domain, whose first coordinate is the parameter: exact.
/// @throws InvalidArgument a rational curve
[[nodiscard]] TANDEM_EXPORT Curve graph_of(const Curve& motion);

}  // namespace v0
}  // namespace tandem
