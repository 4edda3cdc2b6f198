#include "tandem/match/validity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "match/curve_pair.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::CurvePair;
using detail::PairState;

/// Chords of a span at which both curves are looked at; between them only where the directions turn so far
/// that the value might change its sign.
constexpr std::size_t kChords = 8;
/// Halvings of such a chord: a cusp is found when its tangents flip within 1/8192 of a span or more.
constexpr std::size_t kHalvings = 10;
/// Turning between two samples of different sign below which the crossing is interpolated, not halved: 0.6
/// degrees.
constexpr double kFineTurning = 0.01;
/// Local minima this much above the lowest sample may still be the minimum after sharpening, and no more than
/// kMostSharpened of them are looked at.
constexpr double kNearMinimum = 0.02;
constexpr std::size_t kMostSharpened = 8;
/// What the parabola through three samples must promise before it is worth while to sharpen a minimum.
constexpr double kWorthSharpening = 1e-9;
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
  double value = 0.0;
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
bool backtracks(const double* a_in, const double* a_out, const double* b_in, const double* b_out) {
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
      : pair_(a, b, norm, kChords + 1 + kHalvings),
        signs_(pair_.is_signed() ? 2 : 1),
        seam_(a.is_closed() && b.is_closed()) {}

  Validity run() {
    for (std::size_t span = 0; span < pair_.spans(); ++span) look_at_span(span);
    if (pair_.dim() == 2 && seam_) look_at_corner(first_start_);
    const std::size_t sigma = better_sign();
    sharpen(sigma);
    return summary(sigma);
  }

 private:
  /// Tangents of both curves in the plane: a's x and y, b's x and y.
  using PlanarTangents = std::array<double, 4>;

  void look_at_span(std::size_t span) {
    pair_.enter_span(span);
    std::array<PairState, kChords + 1> states;
    states.front() = pair_.at_start(0);
    states.back() = pair_.at_end(kChords);
    const double lo = states.front().u;
    const double hi = states.back().u;
    for (std::size_t i = 1; i < kChords; ++i) {
      states[i] = pair_.inside(i, lo + (hi - lo) * (static_cast<double>(i) / static_cast<double>(kChords)));
    }
    for (std::size_t i = 0; i < kChords; ++i) look_between(states[i], states[i + 1], kHalvings);
    for (const PairState& state : states) meet(state);
    find_valleys(span, states);
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

  void meet(const PairState& state) {
    for (std::size_t sigma = 0; sigma < signs_; ++sigma) tallies_[sigma].meet(state, sigma);
  }

  /// Adds the part between two samples to the sums; halved first where the sign might change unseen.
  void look_between(const PairState& from, const PairState& to, std::size_t halvings) {
    if (halvings > 0 && might_change_sign(from, to)) {
      const PairState middle = pair_.inside(kChords + halvings, from.u + 0.5 * (to.u - from.u));
      meet(middle);
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
      tally.dot_a += half * (from.speed_a * from.value[sigma] + to.speed_a * to.value[sigma]);
      tally.dot_b += half * (from.speed_b * from.value[sigma] + to.speed_b * to.value[sigma]);
      const double share = invalid_share(from.value[sigma], to.value[sigma]);
      tally.invalid_a += share * way_a;
      tally.invalid_b += share * way_b;
    }
  }

  [[nodiscard]] bool might_change_sign(const PairState& from, const PairState& to) const {
    const double turning = pair_.turning(from, to);
    for (std::size_t sigma = 0; sigma < signs_; ++sigma) {
      const double low = std::min(from.margin[sigma], to.margin[sigma]);
      const double high = std::max(from.margin[sigma], to.margin[sigma]);
      if (low > 0.0 && low < turning) return true;
      if (low <= 0.0 && high > 0.0 && turning > kFineTurning) return true;
    }
    return false;
  }

  void find_valleys(std::size_t span, const std::array<PairState, kChords + 1>& states) {
    for (std::size_t sigma = 0; sigma < signs_; ++sigma) {
      for (std::size_t i = 0; i <= kChords; ++i) {
        const PairState& before = states[i == 0 ? 0 : i - 1];
        const PairState& after = states[i == kChords ? kChords : i + 1];
        const double here = states[i].value[sigma];
        if (here > tallies_[sigma].least + kNearMinimum) continue;
        const double left = before.value[sigma] - here;
        const double right = after.value[sigma] - here;
        if (left < 0.0 || right < 0.0) continue;
        // At the end of a span the parabola is not known: the slope there might lead down first.
        const bool end = i == 0 || i == kChords;
        const double drop =
            end ? std::max(left, right) : (left - right) * (left - right) / (8.0 * (left + right));
        if (!(drop > kWorthSharpening)) continue;
        valleys_[sigma].push_back({span, before.u, after.u, here});
      }
    }
  }

  /// The sign of the ruled test with which less of the length is invalid.
  [[nodiscard]] std::size_t better_sign() const {
    if (signs_ == 1) return 0;
    return invalid(tallies_[1]) < invalid(tallies_[0]) ? 1 : 0;
  }

  [[nodiscard]] static double share_of(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

  [[nodiscard]] double invalid(const Tally& tally) const {
    return 0.5 * share_of(tally.invalid_a, way_a_) + 0.5 * share_of(tally.invalid_b, way_b_);
  }

  /// Golden section in the lowest valleys.
  void sharpen(std::size_t sigma) {
    std::vector<Valley>& valleys = valleys_[sigma];
    const double highest = tallies_[sigma].least + kNearMinimum;
    valleys.erase(std::remove_if(valleys.begin(), valleys.end(),
                                 [highest](const Valley& valley) { return valley.value > highest; }),
                  valleys.end());
    const std::size_t count = std::min(kMostSharpened, valleys.size());
    std::partial_sort(valleys.begin(), valleys.begin() + static_cast<std::ptrdiff_t>(count), valleys.end(),
                      [](const Valley& a, const Valley& b) { return a.value < b.value; });
    for (std::size_t i = 0; i < count; ++i) sharpen(valleys[i], sigma);
  }

  void sharpen(const Valley& valley, std::size_t sigma) {
    constexpr double kGolden = 0.6180339887498949;
    constexpr int kSteps = 20;
    pair_.enter_span(valley.span);
    double lo = valley.lo;
    double hi = valley.hi;
    PairState left = pair_.inside(0, hi - kGolden * (hi - lo));
    PairState right = pair_.inside(1, lo + kGolden * (hi - lo));
    for (int step = 0; step < kSteps; ++step) {
      tallies_[sigma].meet(left, sigma);
      tallies_[sigma].meet(right, sigma);
      if (left.value[sigma] < right.value[sigma]) {
        hi = right.u;
        right = left;
        left = pair_.inside(0, hi - kGolden * (hi - lo));
      } else {
        lo = left.u;
        left = right;
        right = pair_.inside(0, lo + kGolden * (hi - lo));
      }
    }
  }

  [[nodiscard]] Validity summary(std::size_t sigma) const {
    const Tally& tally = tallies_[sigma];
    Validity validity;
    validity.min_dot = tally.least;
    validity.worst_u = tally.worst_u;
    validity.valid = tally.least > 0.0 && !backtracks_;
    validity.valid_share = 1.0 - invalid(tally);
    // Where one curve is a point the other one alone has a length.
    const double mean_a = way_a_ > 0.0 ? tally.dot_a / way_a_ : share_of(tally.dot_b, way_b_);
    const double mean_b = way_b_ > 0.0 ? tally.dot_b / way_b_ : mean_a;
    validity.mean_dot = 0.5 * mean_a + 0.5 * mean_b;
    return validity;
  }

  CurvePair pair_;
  std::size_t signs_;  ///< 2 when the sign of the ruled test is still to be chosen
  bool seam_;          ///< the end of the domain is a corner like any other
  Tally tallies_[2];
  std::vector<Valley> valleys_[2];
  double way_a_ = 0.0;  ///< length in units of the curve's size
  double way_b_ = 0.0;
  PlanarTangents first_start_{};
  PlanarTangents last_end_{};
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
