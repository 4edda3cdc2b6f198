#pragma once

#include <cstddef>
#include <vector>

#include "match/span_curve.h"
#include "tandem/curve/curve.h"
#include "tandem/match/norm.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// What the norms say of two curves at one parameter, seen from one side. Index 0 and 1: the planar ruled
/// test with sigma = +1 and -1 (spec C13); both the same in any other norm.
struct PairState {
  double u = 0.0;
  double value[2] = {1.0, 1.0};  ///< the norm's value; negative where the signed test fails
  double margin[2] = {1.0,
                      1.0};  ///< > 0 where the value is; ruled norm: shrinks by no more than directions turn
  double speed_a = 0.0;      ///< |a'| in units of a's size
  double speed_b = 0.0;
  const double* tangent_a = nullptr;  ///< unit; zero where the curve stands still
  const double* tangent_b = nullptr;
  const double* chord = nullptr;  ///< ruled norm: direction from a to b, unit; zero where they meet
  double gap = 0.0;               ///< ruled norm: |b - a|, in units of the larger curve's size
  double gap_speed = 0.0;         ///< |b' - a'| likewise
};

/// Evaluates two curves of one dimension over one domain together, span by span.
///
/// A span reaches from one knot of either curve to the next. Unit tangents are one-sided limits: where the
/// speed is zero, the first derivative that is not gives the direction; inside a span, from the side with the
/// lower value.
class CurvePair {
 public:
  /// chords: nodes per span, less one. slots: how many states are kept at a time; a new state in a slot takes
  /// the directions of the old one away.
  CurvePair(const Curve& a, const Curve& b, NormKind norm, std::size_t chords, std::size_t slots);

  [[nodiscard]] std::size_t dim() const { return dim_; }
  [[nodiscard]] std::size_t spans() const { return spans_.size(); }
  [[nodiscard]] bool is_ruled() const { return ruled_; }
  /// The planar ruled norm: sigma matters.
  [[nodiscard]] bool is_signed() const { return ruled_ && dim_ == 2; }

  void enter_span(std::size_t i);
  /// Node k of the span, 0 <= k <= chords; at the ends from within.
  [[nodiscard]] PairState at_node(std::size_t slot, std::size_t k);
  /// Strictly inside.
  [[nodiscard]] PairState at(std::size_t slot, double u) { return look_from_both_sides(slot, {u}); }

  /// Tangent norm: its value is certainly positive on this part of the span, whatever happens between
  /// samples. The ruled norm has no such certificate here.
  [[nodiscard]] bool certainly_positive(const Interval& part);
  [[nodiscard]] bool certainly_positive() { return certainly_positive(span_.u); }

  /// How far the directions turn from one state to another.
  [[nodiscard]] double turning(const PairState& from, const PairState& to) const;

 private:
  /// From one knot of either curve to the next: which piece of each curve it is.
  struct Span {
    Interval u;
    std::size_t piece_a;
    std::size_t piece_b;
  };

  [[nodiscard]] PairState look(std::size_t slot, const SpanPlace& place, Side side);
  [[nodiscard]] PairState look_from_both_sides(std::size_t slot, const SpanPlace& place);
  void judge(PairState& state) const;

  std::size_t dim_;
  bool ruled_;
  std::size_t chords_;
  SpanCurve a_;
  SpanCurve b_;
  std::vector<Span> spans_;
  Span span_{};
  std::vector<double> directions_;  ///< slots * 3 * dim
  std::vector<double> points_;      ///< workspace
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
