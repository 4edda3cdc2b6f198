#pragma once

#include <cstddef>
#include <vector>

#include "curve/evaluator.h"
#include "tandem/curve/curve.h"
#include "tandem/match/norm.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// What the norms say of two curves at one parameter, seen from one side. Index 0 and 1: the planar ruled
/// test with sigma = +1 and -1 (spec C13); both the same in any other norm.
struct PairState {
  double u = 0.0;
  double value[2] = {1.0, 1.0};   ///< the norm's value; negative where the signed test fails
  double margin[2] = {1.0, 1.0};  ///< > 0 where the value is; shrinks by no more than the directions turn
  double speed_a = 0.0;           ///< |a'| in units of a's size
  double speed_b = 0.0;
  const double* tangent_a = nullptr;  ///< unit; zero where the curve stands still
  const double* tangent_b = nullptr;
  const double* chord = nullptr;  ///< ruled norm: direction from a to b, unit; zero where they meet
};

/// Evaluates two curves of one dimension over one domain together, span by span.
///
/// A span reaches from one knot of either curve to the next. Unit tangents are one-sided limits: where the
/// speed is zero, the first derivative that is not gives the direction.
class CurvePair {
 public:
  /// slots: how many states are kept at a time; a new state in a slot takes the directions of the old one
  /// away.
  CurvePair(const Curve& a, const Curve& b, NormKind norm, std::size_t slots);

  [[nodiscard]] std::size_t dim() const { return dim_; }
  [[nodiscard]] std::size_t spans() const { return breaks_.size() - 1; }
  /// The planar ruled norm: sigma matters.
  [[nodiscard]] bool is_signed() const { return ruled_ && dim_ == 2; }

  void enter_span(std::size_t i);
  [[nodiscard]] PairState at_start(std::size_t slot);
  [[nodiscard]] PairState at_end(std::size_t slot);
  /// Strictly inside; where a speed is zero, the worse of both sides.
  [[nodiscard]] PairState inside(std::size_t slot, double u);

  /// How far the directions turn from one state to another.
  [[nodiscard]] double turning(const PairState& from, const PairState& to) const;

 private:
  /// A knot of either curve, in each curve's own rounding of it.
  struct Break {
    double u_a;
    double u_b;
  };

  struct OneCurve {
    explicit OneCurve(const Curve& curve);

    Evaluator evaluator;
    double size;          ///< of the curve
    double rounding;      ///< of its coordinates
    double length = 1.0;  ///< of the current span
  };

  /// Unit tangent from `side` into `direction`, the point into `position`; returns the speed.
  double look(const OneCurve& curve, double u, Side side, double* position, double* direction);
  double limit(const OneCurve& curve, double u, Side side, double* direction);
  PairState look_at(std::size_t slot, double u_a, double u_b, Side side);
  void judge(PairState& state) const;

  std::size_t dim_;
  bool ruled_;
  OneCurve a_;
  OneCurve b_;
  std::vector<Break> breaks_;
  std::size_t span_ = 0;
  std::vector<double> directions_;   ///< slots * 3 * dim
  std::vector<double> scratch_;      ///< two points
  std::vector<double> derivatives_;  ///< workspace of limit()
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
