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
  /// Slopes of v, relative to the mean slope, stay within [min_slope, 1 / min_slope]; 0 < min_slope <= 1.
  double min_slope = 1e-3;
};

/// v(u): strictly increasing, from the first curve's domain onto the second's (of the reversed second curve
/// when `reversed`; closed curves: onto one period of it, starting wherever v(lo) lies).
struct Reparametrization {
  Curve v;  ///< a scalar curve, dim 1
  /// Largest |v(u) - path| over the path's points, as a share of v's domain; where the path steps up, the
  /// distance to the nearest point of the step.
  double max_deviation = 0.0;
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

/// Fits v(u) over [first u, last u] of the path; both ends are met exactly.
///
/// With coefficients: the paper's reduction, least squares over uniform knots, as a constrained one, exact to
/// rounding (active sets). The slopes of the control polygon, which are the coefficients of v', stay in the
/// range, and so does v'. All points count, also those of a vertical step; corners are not special. Where
/// there are no data (more coefficients than points) a pull towards uniform speed decides, 1e-12 of the
/// data's weight.
///
/// By tolerance and order 2: the fewest vertices of the path such that v stays within the tolerance at all of
/// them, corners among them. Of a vertical step the middle is the vertex, and v may pass anywhere through it.
/// Where the path is flatter or steeper than the slopes allow, its vertices are moved first, as little as
/// possible, corners last.
///
/// By tolerance and higher order: the constrained fit from corner to corner (corners are knots of
/// multiplicity degree, v is C0 there), with spans halved until the tolerance holds or they are shorter than
/// 1/1024 of the domain (1/16 of a piece, if that is less). Where the slopes forbid the tolerance, or halving
/// has ended, the best fit is returned; max_deviation tells.
///
/// @throws InvalidArgument fewer coefficients than the order or more than 1,000,000; order outside 2 .. 32;
///         tolerance <= 0; min_slope outside (0, 1]; a path that is empty, steps back or does not rise; more
///         coefficients than doubles can tell apart in the domains
[[nodiscard]] TANDEM_EXPORT Reparametrization fit(const FitPath& path, const ReductionOptions& options,
                                                  bool reversed = false);

}  // namespace v0
}  // namespace tandem
