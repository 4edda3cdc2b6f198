#pragma once

#include <cstddef>
#include <vector>

#include "tandem/curve/interval.h"
#include "tandem/curve/points.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// From which side a value is taken where a curve is not smooth.
enum class Side { left, right };

/// A parametric curve in R^n: Bezier, B-spline or NURBS, any degree >= 1, any knot vector, n >= 1.
///
/// An immutable regular value; an existing Curve is valid. The knot vector may be unclamped: the domain is
/// [knots[degree], knots[size()]]. Whether a curve is closed or periodic is a fact of the value.
/// Knots may have multiplicity up to degree + 1 at the ends of the domain and degree within (a corner, C0).
class TANDEM_EXPORT Curve {
 public:
  /// control_points: dim x n, Euclidean (not premultiplied by the weights); knots: n + degree + 1,
  /// non-decreasing; weights: empty (polynomial) or n, all > 0. Coordinates and knots up to 1e304 in size,
  /// weights within [1e-100, 1e100]: what is computed from them then stays within the range of double.
  /// @throws InvalidArgument a size disagrees, a number is not finite or too large, knots decrease, an
  ///         interior multiplicity exceeds the degree (the curve would break), the domain is empty, or a
  ///         weight is <= 0
  Curve(int degree, std::vector<double> knots, Points control_points, std::vector<double> weights = {});

  /// The Bezier curve of degree n - 1 over `domain`.
  [[nodiscard]] static Curve bezier(Points control_points, std::vector<double> weights = {},
                                    Interval domain = {0.0, 1.0});
  /// The B-spline with clamped uniform knots on [0,1].
  [[nodiscard]] static Curve clamped_uniform(int degree, Points control_points,
                                             std::vector<double> weights = {});

  [[nodiscard]] int degree() const noexcept { return degree_; }
  [[nodiscard]] int dim() const noexcept { return control_points_.dim(); }
  /// Number of control points.
  [[nodiscard]] std::size_t size() const noexcept { return control_points_.size(); }
  [[nodiscard]] const std::vector<double>& knots() const noexcept { return knots_; }
  [[nodiscard]] const Points& control_points() const noexcept { return control_points_; }
  /// Empty for a polynomial curve.
  [[nodiscard]] const std::vector<double>& weights() const noexcept { return weights_; }
  [[nodiscard]] bool is_rational() const noexcept { return !weights_.empty(); }
  [[nodiscard]] Interval domain() const noexcept {
    return {knots_[static_cast<std::size_t>(degree_)], knots_[control_points_.size()]};
  }

  /// The ends meet within 1e-9 of the curve's size, and the curve is more than a point.
  [[nodiscard]] bool is_closed() const noexcept { return closed_; }
  /// The knot spacing and the last `degree` control points (and weights) repeat the first ones: the curve is
  /// smooth across the seam.
  [[nodiscard]] bool is_periodic() const noexcept { return periodic_; }
  /// Diagonal of the control points' bounding box, without overflow; 0 for a point.
  [[nodiscard]] double extent() const noexcept { return extent_; }

  /// The point at t, clamped to the domain. @throws InvalidArgument t is NaN (derivatives too)
  [[nodiscard]] Point evaluate(double t) const;
  /// Derivatives 0..order at t (clamped to the domain): order + 1 rows of R^dim; zero above the degree of a
  /// polynomial curve. At a knot `side` decides; at the ends of the domain there is only one. Derivatives
  /// beyond the range of double are cut off.
  [[nodiscard]] Points derivatives(double t, int order, Side side = Side::right) const;

  friend bool operator==(const Curve&, const Curve&) = default;

 private:
  int degree_;
  std::vector<double> knots_;
  Points control_points_;
  std::vector<double> weights_;
  double extent_ = 0.0;
  bool closed_ = false;
  bool periodic_ = false;
};

}  // namespace v0
}  // namespace tandem
