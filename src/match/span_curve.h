#pragma once

#include <cstddef>
#include <vector>

#include "curve/evaluator.h"
#include "curve/spline.h"
#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A parameter in a span, and which node it is, if it is one.
struct SpanPlace {
  static constexpr std::size_t kNoNode = static_cast<std::size_t>(-1);
  double u = 0.0;
  std::size_t node = kNoNode;
};

/// Evaluates a curve's unit tangents many times, span by span, at equidistant nodes: several times as fast as
/// looking for every parameter's span and forming its B-splines. The curve must outlive it.
class SpanCurve {
 public:
  /// chords: nodes per span, less one.
  SpanCurve(const Curve& curve, std::size_t chords);

  /// Ends of the curve's own spans.
  [[nodiscard]] const std::vector<Break>& breaks() const { return pieces_.breaks; }

  /// From now on parameters lie in `span`, which lies in the curve's own span i.
  void enter(std::size_t i, const Interval& span);

  /// Unit tangent into `tangent`, and the point into `point` unless it is null; at the ends of the span from
  /// within. Returns the speed in units of the curve's size. Where that is zero the tangent is the limit from
  /// `side`, and zero itself where the curve stands still.
  double look(const SpanPlace& place, Side side, double* tangent, double* point);

  /// Differences of the Bezier points over `part`, a part of the span, in units of the curve's size: degree *
  /// dim numbers. Every tangent there is a combination of them with factors >= 0, of rational curves as well.
  /// Valid until the next call.
  [[nodiscard]] const std::vector<double>& edges(const Interval& part);

  /// Unit of the speeds: the curve's extent, 1 for a point.
  [[nodiscard]] double size() const { return size_; }
  /// What rounding makes of a coordinate: one unit in the last place of the largest, more for uneven weights.
  [[nodiscard]] double rounding() const { return rounding_; }

 private:
  double movement(const double* lower, const double* upper, double* tangent, double* point);
  double limit(double u, Side side, double* tangent);

  Evaluator evaluator_;
  Pieces pieces_;
  std::size_t dim_;
  std::size_t degree_;
  std::size_t stride_;
  std::size_t chords_;
  double size_;
  double rounding_;
  Interval span_;
  std::vector<double> coefficients_;  ///< Bezier points of the span
  std::vector<double> differences_;   ///< of these, times the degree
  std::vector<double> lower_;  ///< Bernstein polynomials of one degree less, at every node and one free place
  std::vector<double> upper_;  ///< of the degree
  std::vector<double> part_;   ///< workspace of edges()
  std::vector<double> edges_;
  std::vector<double> workspace_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
