#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "surface/enclosure.h"
#include "tandem/curve/curve.h"
#include "tandem/curve/interval.h"
#include "tandem/surface/surface.h"

namespace tandem {
inline namespace v0 {
namespace detail {

using Enclosures = std::vector<Enclosure>;

/// Where and how large things are, so that the numbers of a proof are near 1 and lose little: points are
/// moved by -origin, where that is much larger than their distances, and scaled by 2^exponent. Both is exact
/// (unless it ends among the subnormal numbers), so control points that are equal stay so. Signs of
/// Jacobians, and whether things meet, do not change.
struct Frame {
  Point origin;
  int exponent = 0;
};

/// The frame in which all these points are about 1 in size.
[[nodiscard]] Frame frame_of(std::span<const Points* const> clouds);

/// The control points in a frame, `dim` numbers each and, if `rational`, multiplied by their weights (none:
/// 1), which follow as the last number, scaled by a power of two to at most 1 or so. Exact or enclosed.
[[nodiscard]] Enclosures homogeneous(const Points& points, const std::vector<double>& weights, bool rational,
                                     const Frame& frame);

/// Number c of each group of `stride`.
[[nodiscard]] Enclosures component(const Enclosures& coefficients, std::size_t stride, std::size_t c);

/// A spline whose coefficients, `stride` numbers each, are only known to lie in enclosures. The knots are
/// exact.
class EnclosedSpline {
 public:
  EnclosedSpline(int degree, std::vector<double> knots, Enclosures coefficients, std::size_t stride);

  [[nodiscard]] int degree() const noexcept { return degree_; }
  [[nodiscard]] std::size_t stride() const noexcept { return stride_; }
  [[nodiscard]] std::size_t size() const noexcept { return coefficients_.size() / stride_; }
  [[nodiscard]] Interval domain() const noexcept {
    return {knots_[static_cast<std::size_t>(degree_)], knots_[size()]};
  }
  /// The distinct knots of the domain, its ends among them, and where a weld begins.
  [[nodiscard]] std::vector<double> breaks() const;

  /// The degree + 1 Bezier coefficients of the part over [part.lo, part.hi], with no break inside.
  [[nodiscard]] Enclosures bezier(Interval part) const;
  /// The `degree` Bezier coefficients of the derivative of that part, by the part's own parameter in [0,1],
  /// without the factor `degree`. Taken from differences of the spline's own coefficients, so that parts as
  /// short as rounding errors of the knots have derivatives as accurate as any.
  [[nodiscard]] Enclosures hodograph(Interval part) const;

  /// Closes a spline whose ends differ by rounding errors, by a gap g: from now on it stands for all splines
  /// C(t) + s g x(t)^degree, 0 <= s <= 1, where x runs from 0 at `from` to 1 at the end, and `from`, in the
  /// last span, is one of its breaks. Coefficients are groups of dim numbers and, if rational, their weight.
  void weld(std::size_t dim, bool rational, double from);

  /// The spline whose coefficients are map(coefficient), where map, from Enclosures to Enclosures, is linear.
  template <class Map>
  [[nodiscard]] EnclosedSpline mapped(Map map) const {
    Enclosures all;
    for (std::size_t i = 0; i < size(); ++i) {
      const auto first = coefficients_.begin() + static_cast<std::ptrdiff_t>(i * stride_);
      const Enclosures one = map(Enclosures(first, first + static_cast<std::ptrdiff_t>(stride_)));
      all.insert(all.end(), one.begin(), one.end());
    }
    const std::size_t stride = all.size() / size();
    EnclosedSpline result(degree_, knots_, std::move(all), stride);
    if (!gap_.empty()) result.gap_ = map(gap_);
    result.gap_from_ = gap_from_;
    return result;
  }

 private:
  [[nodiscard]] std::size_t span_of(Interval part) const;
  /// 0 or what is added to the coefficients of a piece of `degree` at the end, but for the factor g.
  [[nodiscard]] Enclosures gap_shares(Interval part) const;
  void add_gap(const Enclosures& shares, Enclosures& coefficients) const;

  int degree_;
  std::size_t stride_;
  std::vector<double> knots_;
  Enclosures coefficients_;
  Enclosures gap_;  // when welded: between nothing and the way from the end to the start
  double gap_from_ = 0.0;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
