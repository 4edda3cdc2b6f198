#pragma once

#include <optional>
#include <span>

#include "tandem/curve/curve.h"
#include "tandem/match/correspondence.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// How v(u) is made from a path (spec C7).
struct ReductionOptions {
  /// Number of coefficients of a uniform-knot least-squares fit ([C]: 20). Empty: by tolerance.
  std::optional<int> coefficients = {};
  /// Largest |v(u) - path| allowed, as a share of v's domain, when there is no number of coefficients.
  double tolerance = 1e-3;
  /// Order (degree + 1) of v: 2 is piecewise linear.
  int order = 2;
  /// Slopes of v, relative to the mean slope, stay within [min_slope, 1 / min_slope].
  double min_slope = 1e-3;
};

/// v(u): strictly increasing, from the first curve's domain onto the second's (of the reversed second curve
/// when `reversed`; closed curves: onto one period of it, starting wherever v(lo) lies).
struct Reparametrization {
  Curve v;                     ///< a scalar curve, dim 1
  double max_deviation = 0.0;  ///< largest |v(u) - path| over the path's points, as a share of v's domain
  bool reversed = false;
};

/// A path prepared for the fit: points over one period of u, from domain_u.lo to domain_u.hi, v never
/// decreasing.
struct FitPath {
  std::vector<ParameterPair> points;
  std::vector<double> corner_parameters;  ///< u of points that v must pass through exactly (corners)
};

/// The path as the fit sees it: cut open at domain_u.lo, and v turned round when reversed.
/// corners: u parameters at which the path must be met exactly; those that are not on the path are left out.
[[nodiscard]] TANDEM_EXPORT FitPath fit_path(const Correspondence& correspondence,
                                             std::span<const double> corners = {});

/// Fits v(u).
///
/// With coefficients: least squares over uniform knots, increments of the control polygon >= min_slope times
/// their mean and their sum fixed (a constrained least squares: monotone by variation diminishing). By
/// tolerance and order 2: the fewest vertices of the path, found greedily, corners among them. By tolerance
/// and higher order: the constrained fit with knots doubled until the tolerance holds (corners become knots
/// of full multiplicity).
/// @throws InvalidArgument fewer coefficients than the order, order < 2, tolerance <= 0, an empty path
[[nodiscard]] TANDEM_EXPORT Reparametrization fit(const FitPath& path, const ReductionOptions& options,
                                                  bool reversed = false);

}  // namespace v0
}  // namespace tandem
