#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/curve/interval.h"
#include "tandem/curve/points.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// The two parameters of a surface S(u, v). Surfaces that are made of curves have those along u.
enum class Along { u, v };

/// From which side a value is taken in either parameter where a surface is not smooth.
struct SurfaceSides {
  Side u = Side::right;
  Side v = Side::right;
};

/// The two degrees, knot vectors and domains of a surface, u first.
using SurfaceDegree = std::array<int, 2>;
using SurfaceKnots = std::array<std::vector<double>, 2>;

/// A tensor-product surface in R^n: Bezier, B-spline or NURBS, any degrees >= 1, any knot vectors.
///
/// An immutable regular value; an existing Surface is valid. What is said of the knots of a Curve holds for
/// both knot vectors.
class TANDEM_EXPORT Surface {
 public:
  /// control_points: dim x (m * n), Euclidean, point (i, j) at index i * n + j, i along u; knots: m + p + 1
  /// and n + q + 1; weights: empty (polynomial) or m * n, all > 0. Sizes of numbers as in Curve.
  /// @throws InvalidArgument as Curve's constructor; the message says along which parameter
  Surface(SurfaceDegree degree, SurfaceKnots knots, Points control_points, std::vector<double> weights = {});

  /// The surface whose rows of control points along u are those of `rows`: curve j stands for control points
  /// (., j), and degree and knots are those along v.
  /// @throws InvalidArgument the rows differ in degree, knots or dimension, or some are rational and others
  /// are not; and as the constructor
  [[nodiscard]] static Surface of_rows(std::span<const Curve> rows, int degree, std::vector<double> knots);

  [[nodiscard]] int degree(Along along) const noexcept { return degree_[index(along)]; }
  [[nodiscard]] int dim() const noexcept { return control_points_.dim(); }
  /// Number of control points along one parameter.
  [[nodiscard]] std::size_t size(Along along) const noexcept {
    return knots_[index(along)].size() - static_cast<std::size_t>(degree_[index(along)]) - 1;
  }
  [[nodiscard]] const std::vector<double>& knots(Along along) const noexcept { return knots_[index(along)]; }
  [[nodiscard]] const Points& control_points() const noexcept { return control_points_; }
  [[nodiscard]] std::span<const double> control_point(std::size_t i, std::size_t j) const noexcept {
    return control_points_[i * size(Along::v) + j];
  }
  /// Empty for a polynomial surface.
  [[nodiscard]] const std::vector<double>& weights() const noexcept { return weights_; }
  [[nodiscard]] bool is_rational() const noexcept { return !weights_.empty(); }
  [[nodiscard]] Interval domain(Along along) const noexcept {
    return {knots(along)[static_cast<std::size_t>(degree(along))], knots(along)[size(along)]};
  }
  /// The two edges across `along` meet, within 1e-9 of the surface's size: the curves along it are closed.
  [[nodiscard]] bool is_closed(Along along) const noexcept { return closed_[index(along)]; }
  /// Diagonal of the control points' bounding box, without overflow; 0 for a point.
  [[nodiscard]] double extent() const noexcept { return extent_; }

  /// The point at (u, v), clamped to the domain. @throws InvalidArgument NaN (derivatives and normal, too)
  [[nodiscard]] Point evaluate(double u, double v) const;
  /// All partial derivatives of total order up to `order`: the one k times by u and l times by v is row
  /// (k + l) * (k + l + 1) / 2 + l, so S, S_u, S_v, S_uu, S_uv, S_vv, ... At knots the sides decide.
  [[nodiscard]] Points derivatives(double u, double v, int order, SurfaceSides sides = {}) const;
  /// The unit normal S_u x S_v. Where a partial derivative vanishes or both are parallel (a pole, say), the
  /// limit from inside, to some six digits; zero where the surface has none (it is a curve or a point there).
  /// @throws InvalidArgument the surface is not in R^3
  [[nodiscard]] Point normal(double u, double v, SurfaceSides sides = {}) const;

  friend bool operator==(const Surface&, const Surface&) = default;

 private:
  static constexpr std::size_t index(Along along) noexcept { return along == Along::u ? 0 : 1; }
  [[nodiscard]] bool edges_meet(Along along) const;

  SurfaceDegree degree_;
  SurfaceKnots knots_;
  Points control_points_;
  std::vector<double> weights_;
  double extent_ = 0.0;
  std::array<bool, 2> closed_{};
};

}  // namespace v0
}  // namespace tandem
