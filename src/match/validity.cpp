#include "tandem/match/validity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "match/curve_pair.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::CurvePair;
using detail::PairState;

/// Chords of a span at which both curves are looked at; halved where more may happen between the samples.
constexpr std::size_t kChords = 8;
/// Halvings of such a chord: a cusp is found when its tangents flip within 1/8192 of a span or more.
constexpr std::size_t kHalvings = 10;
/// Turning of both curves together between two samples, in radians: above the first a chord is halved in any
/// case, below the second a change of sign is interpolated.
constexpr double kCoarseTurning = 0.5;
constexpr double kFineTurning = 0.01;
/// How many valleys are sharpened, the most promising first.
constexpr std::size_t kMostSharpened = 8;
/// Valleys no deeper than this are rounding, or not worth the while.
constexpr double kDepth = 1e-9;
/// Shares of the length, and values, that differ by no more than rounding.
constexpr double kTie = 1e-12;
/// Angles may be off by this much before a turn counts as more than half a circle.
constexpr double kAngleRounding = 1e-9;
/// Domains may differ by rounding of a change of parameter.
constexpr double kSameDomain = 1e-12;

/// Sums over the length of both curves and the minimum, for one sign of the ruled test.
struct Tally {
  double least = std::numeric_limits<double>::infinity();
  double worst_u = 0.0;
  double dot_a = 0.0;
  double dot_b = 0.0;
  double invalid_a = 0.0;
  double invalid_b = 0.0;

  void meet(const PairState& state, std::size_t sigma) {
    if (state.value[sigma] < least) {
      least = state.value[sigma];
      worst_u = state.u;
    }
  }
};

/// Three samples in a row, the middle one the lowest: where the minimum is to be sharpened.
struct Valley {
  std::size_t span = 0;
  double lo = 0.0;
  double hi = 0.0;
  double promise = 0.0;  ///< how low the bottom might be
};

/// Finds the valleys in a row of samples of one span.
class ValleyFinder {
 public:
  void start(std::size_t span, double u, double value) {
    span_ = span;
    before_u_ = u_ = u;
    before_ = value_ = value;
  }

  void next(double u, double value) {
    const double wall = std::max(before_ - value_, value - value_);
    if (value_ <= before_ && value_ <= value && wall > kDepth) {
      // A parabola's bottom lies within an eighth of the higher wall below its lowest sample; be generous.
      valleys_.push_back({span_, before_u_, u, value_ - 0.5 * wall});
    }
    before_u_ = u_;
    before_ = value_;
    u_ = u;
    value_ = value;
  }

  /// The row ends with the last sample.
  void finish() { next(u_, value_); }

  /// The most promising valleys that might lie below `least`.
  [[nodiscard]] std::vector<Valley> best(double least) {
    const auto higher = [least](const Valley& valley) { return valley.promise >= least; };
    valleys_.erase(std::remove_if(valleys_.begin(), valleys_.end(), higher), valleys_.end());
    std::sort(valleys_.begin(), valleys_.end(),
              [](const Valley& a, const Valley& b) { return a.promise < b.promise; });
    if (valleys_.size() > kMostSharpened) valleys_.resize(kMostSharpened);
    return std::move(valleys_);
  }

 private:
  std::size_t span_ = 0;
  double before_u_ = 0.0;
  double before_ = 0.0;
  double u_ = 0.0;
  double value_ = 0.0;
  std::vector<Valley> valleys_;
};

/// Share of the chord between two samples on which the value is not positive.
double invalid_share(double from, double to) {
  if (from > 0.0 && to > 0.0) return 0.0;
  if (from <= 0.0 && to <= 0.0) return 1.0;
  const double low = std::min(from, to);
  const double high = std::max(from, to);
  return low / (low - high);
}

/// Signed angle from one unit vector of the plane to another, in (-pi, pi].
double angle(const double* from, const double* to) {
  return std::atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
}

/// Does the turn at a corner pass pi on the way from the first curve to the second (spec C13)? Blended
/// tangents turn from the first curve's to the second's on either side of the corner, by less than pi each.
/// A curve that stands still on one side has no corner.
bool backtracks(const double* a_in, const double* a_out, const double* b_in, const double* b_out) {
  for (const double* tangent : {a_in, a_out, b_in, b_out}) {
    if (tangent[0] == 0.0 && tangent[1] == 0.0) return false;
  }
  // Less than a quarter turn in both curves: with less than that between them (else the pair is invalid
  // anyway) the sum below cannot leave (-pi, pi).
  if (a_in[0] * a_out[0] + a_in[1] * a_out[1] > 0.0 && b_in[0] * b_out[0] + b_in[1] * b_out[1] > 0.0)
    return false;
  constexpr double kPi = std::numbers::pi;
  const double change = angle(a_out, b_out) - angle(a_in, b_in);
  const double turn = angle(a_in, a_out);
  if (std::abs(turn + change) <= kPi + kAngleRounding) return false;
  // A cusp turns by pi to either side.
  const bool cusp = std::abs(turn) >= kPi - kAngleRounding;
  const double other = turn - std::copysign(2.0 * kPi, turn);
  return !(cusp && std::abs(other + change) <= kPi + kAngleRounding);
}

class Check {
 public:
  Check(const Curve& a, const Curve& b, NormKind norm)
      : pair_(a, b, norm, kChords, kChords + 1 + kHalvings),
        signs_(pair_.is_signed() ? 2 : 1),
        seam_(a.is_closed() && b.is_closed()) {}

  Validity run() {
    for (std::size_t span = 0; span < pair_.spans(); ++span) look_at_span(span);
    if (pair_.dim() == 2 && seam_) look_at_corner(first_start_);
    const std::size_t sigma = better_sign();
    for (const Valley& valley : finders_[sigma].best(tallies_[sigma].least)) sharpen(valley, sigma);
    return summary(sigma);
  }

 private:
  /// Tangents of both curves in the plane: a's x and y, b's x and y.
  using PlanarTangents = std::array<double, 4>;

  void look_at_span(std::size_t span) {
    pair_.enter_span(span);
    certain_ = pair_.certainly_positive();
    std::array<PairState, kChords + 1> states;
    for (std::size_t i = 0; i <= kChords; ++i) states[i] = pair_.at_node(i, i);
    for (std::size_t sigma = 0; sigma < signs_; ++sigma) {
      finders_[sigma].start(span, states.front().u, states.front().value[sigma]);
      tallies_[sigma].meet(states.front(), sigma);
    }
    for (std::size_t i = 0; i < kChords; ++i) look_between(states[i], states[i + 1], kHalvings);
    for (std::size_t sigma = 0; sigma < signs_; ++sigma) finders_[sigma].finish();
    if (pair_.dim() == 2) {
      const PlanarTangents start = planar(states.front());
      if (span == 0) {
        first_start_ = start;
      } else {
        look_at_corner(start);
      }
      last_end_ = planar(states.back());
    }
  }

  static PlanarTangents planar(const PairState& state) {
    return {state.tangent_a[0], state.tangent_a[1], state.tangent_b[0], state.tangent_b[1]};
  }

  /// Compares the tangents after a corner with those of the span before.
  void look_at_corner(const PlanarTangents& out) {
    const double* in = last_end_.data();
    backtracks_ = backtracks_ || backtracks(in, out.data(), in + 2, out.data() + 2);
  }

  /// Adds the part between two samples to the sums, the second sample included; halved first where too much
  /// might happen unseen.
  void look_between(const PairState& from, const PairState& to, std::size_t halvings) {
    if (halvings > 0 && might_hide_something(from, to)) {
      const PairState middle = pair_.at(kChords + halvings, from.u + 0.5 * (to.u - from.u));
      look_between(from, middle, halvings - 1);
      look_between(middle, to, halvings - 1);
      return;
    }
    const double half = 0.5 * (to.u - from.u);
    const double way_a = half * (from.speed_a + to.speed_a);
    const double way_b = half * (from.speed_b + to.speed_b);
    way_a_ += way_a;
    way_b_ += way_b;
    for (std::size_t sigma = 0; sigma < signs_; ++sigma) {
      Tally& tally = tallies_[sigma];
      tally.meet(to, sigma);
      finders_[sigma].next(to.u, to.value[sigma]);
      tally.dot_a += half * (from.speed_a * from.value[sigma] + to.speed_a * to.value[sigma]);
      tally.dot_b += half * (from.speed_b * from.value[sigma] + to.speed_b * to.value[sigma]);
      const double share = invalid_share(from.value[sigma], to.value[sigma]);
      tally.invalid_a += share * way_a;
      tally.invalid_b += share * way_b;
    }
  }

  [[nodiscard]] bool might_hide_something(const PairState& from, const PairState& to) {
    const double turning = pair_.turning(from, to);
    if (turning > kCoarseTurning) return true;
    if (!pair_.is_ruled()) {
      if (from.value[0] > 0.0 && to.value[0] > 0.0)
        return !certain_ && !pair_.certainly_positive({from.u, to.u});
      return (from.value[0] > 0.0 || to.value[0] > 0.0) && turning > kFineTurning;
    }
    // The curves might meet and part again, with the same direction from one to the other before and after.
    if (std::min(from.gap, to.gap) < std::max(from.gap_speed, to.gap_speed) * (to.u - from.u)) return true;
    for (std::size_t sigma = 0; sigma < signs_; ++sigma) {
      const double low = std::min(from.margin[sigma], to.margin[sigma]);
      const double high = std::max(from.margin[sigma], to.margin[sigma]);
      if (low > 0.0 && low < turning) return true;
      if (low <= 0.0 && high > 0.0 && turning > kFineTurning) return true;
    }
    return false;
  }

  /// The sign of the ruled test with which less of the length is invalid; if that is the same, the one with
  /// the higher minimum, then the higher mean: the order of the curves must not decide.
  [[nodiscard]] std::size_t better_sign() const {
    if (signs_ == 1) return 0;
    const Tally& plus = tallies_[0];
    const Tally& minus = tallies_[1];
    const double shares = invalid(minus) - invalid(plus);
    if (std::abs(shares) > kTie) return shares < 0.0 ? 1 : 0;
    if (std::abs(minus.least - plus.least) > kTie) return minus.least > plus.least ? 1 : 0;
    return mean(minus) > mean(plus) ? 1 : 0;
  }

  [[nodiscard]] static double share_of(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

  [[nodiscard]] double invalid(const Tally& tally) const {
    return 0.5 * share_of(tally.invalid_a, way_a_) + 0.5 * share_of(tally.invalid_b, way_b_);
  }

  /// Golden section.
  void sharpen(const Valley& valley, std::size_t sigma) {
    constexpr double kGolden = 0.6180339887498949;
    constexpr int kSteps = 20;
    pair_.enter_span(valley.span);
    double lo = valley.lo;
    double hi = valley.hi;
    PairState left = pair_.at(0, hi - kGolden * (hi - lo));
    PairState right = pair_.at(1, lo + kGolden * (hi - lo));
    for (int step = 0; step < kSteps; ++step) {
      tallies_[sigma].meet(left, sigma);
      tallies_[sigma].meet(right, sigma);
      if (left.value[sigma] < right.value[sigma]) {
        hi = right.u;
        right = left;
        left = pair_.at(0, hi - kGolden * (hi - lo));
      } else {
        lo = left.u;
        left = right;
        right = pair_.at(0, lo + kGolden * (hi - lo));
      }
    }
  }

  /// Over both lengths; a point has none, and two points do not contradict each other.
  [[nodiscard]] double mean(const Tally& tally) const {
    if (!(way_a_ > 0.0) && !(way_b_ > 0.0)) return 1.0;
    const double mean_a = share_of(tally.dot_a, way_a_);
    const double mean_b = share_of(tally.dot_b, way_b_);
    if (!(way_a_ > 0.0)) return mean_b;
    if (!(way_b_ > 0.0)) return mean_a;
    return 0.5 * mean_a + 0.5 * mean_b;
  }

  [[nodiscard]] Validity summary(std::size_t sigma) const {
    const Tally& tally = tallies_[sigma];
    Validity validity;
    validity.min_dot = tally.least;
    validity.worst_u = tally.worst_u;
    validity.valid = tally.least > 0.0 && !backtracks_;
    validity.valid_share = 1.0 - invalid(tally);
    validity.mean_dot = mean(tally);
    return validity;
  }

  CurvePair pair_;
  std::size_t signs_;  ///< 2 when the sign of the ruled test is still to be chosen
  bool seam_;          ///< the end of the domain is a corner like any other
  Tally tallies_[2];
  ValleyFinder finders_[2];
  double way_a_ = 0.0;  ///< length in units of the curve's size
  double way_b_ = 0.0;
  PlanarTangents first_start_{};
  PlanarTangents last_end_{};
  bool certain_ = false;  ///< nothing in this span can be invalid
  bool backtracks_ = false;
};

}  // namespace

Validity check_validity(const Curve& a, const Curve& b, NormKind norm) {
  if (a.dim() != b.dim()) {
    throw InvalidArgument(
        fmt::format("the curves have dimensions {} and {}, expected the same", a.dim(), b.dim()));
  }
  const Interval u = a.domain();
  const Interval v = b.domain();
  const double same = kSameDomain * std::max({u.length(), std::abs(u.lo), std::abs(u.hi)});
  if (!(std::abs(u.lo - v.lo) <= same && std::abs(u.hi - v.hi) <= same)) {
    throw InvalidArgument(fmt::format("the curves run over [{}, {}] and [{}, {}], expected the same domain",
                                      u.lo, u.hi, v.lo, v.hi));
  }
  return Check(a, b, norm).run();
}

}  // namespace v0
}  // namespace tandem
