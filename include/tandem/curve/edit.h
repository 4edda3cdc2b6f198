#pragma once

#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/tandem_export.h"

/// Exact editing: every function returns a new curve with the same geometry, or the part of it that it names.
namespace tandem {
inline namespace v0 {

/// The curve over the same domain with knot t inserted `times` times (Boehm / Oslo).
/// @throws InvalidArgument t outside the domain, or the multiplicity would exceed the degree
[[nodiscard]] TANDEM_EXPORT Curve insert_knot(const Curve& curve, double t, int times = 1);

/// All `knots` (non-decreasing, inside the domain) inserted at once.
[[nodiscard]] TANDEM_EXPORT Curve refine(const Curve& curve, std::span<const double> knots);

struct KnotRemoval {
  Curve curve;
  int removed = 0;         ///< how many of the wanted removals stayed within the tolerance
  double deviation = 0.0;  ///< bound on the distance to the given curve
};

/// Removes knot t up to `times` times as long as the curve moves by at most `tolerance` (absolute).
/// Source: Piegl and Tiller, The NURBS Book, A5.8.
[[nodiscard]] TANDEM_EXPORT KnotRemoval remove_knot(const Curve& curve, double t, int times,
                                                    double tolerance);

/// Degree raised by `times`; continuity at the knots is kept (multiplicities grow by `times`).
[[nodiscard]] TANDEM_EXPORT Curve elevate_degree(const Curve& curve, int times = 1);

struct SplitCurve {
  Curve left;
  Curve right;
};

/// The parts over [lo, t] and [t, hi], both clamped.
/// @throws InvalidArgument t is not strictly inside the domain
[[nodiscard]] TANDEM_EXPORT SplitCurve split(const Curve& curve, double t);

/// The part over `part`, clamped. @throws InvalidArgument part is empty or reaches outside the domain
[[nodiscard]] TANDEM_EXPORT Curve subcurve(const Curve& curve, Interval part);

/// Traversed backwards over the same domain: reverse(c)(t) = c(lo + hi - t).
[[nodiscard]] TANDEM_EXPORT Curve reverse(const Curve& curve);

/// The same curve over another domain (affine change of parameter).
/// @throws InvalidArgument the domain is empty
[[nodiscard]] TANDEM_EXPORT Curve with_domain(const Curve& curve, Interval domain);

/// End knots of multiplicity degree + 1; a clamped curve comes back as it is.
[[nodiscard]] TANDEM_EXPORT Curve clamp(const Curve& curve);

/// A closed curve starting at t instead: clamped, over [t, t + period], period = length of the domain.
/// t may lie anywhere on the line; it is taken modulo the period, and the result's domain starts at t itself.
/// The old seam becomes a knot of full multiplicity; of a periodic curve it stays as smooth as it is.
/// @throws InvalidArgument the curve is not closed
[[nodiscard]] TANDEM_EXPORT Curve move_seam(const Curve& closed, double t);

/// One Bezier curve per non-empty span, each over its span.
[[nodiscard]] TANDEM_EXPORT std::vector<Curve> bezier_segments(const Curve& curve);

/// The inverse of bezier_segments: joins clamped curves end to end. Each starts where (parameter and point)
/// the one before it ends; degrees are raised to the highest; joints become C0 knots.
/// @throws InvalidArgument none given, or two do not meet
[[nodiscard]] TANDEM_EXPORT Curve join(std::span<const Curve> curves);

/// The hodograph t -> C'(t); rational curves give a rational curve of twice the degree. A degree-1 curve's
/// derivative is piecewise constant, which a (continuous) Curve cannot hold.
/// @throws InvalidArgument the derivative is not continuous (degree 1 with several spans, or a knot of full
///         multiplicity); use derivatives() with a Side, or take each Bezier segment by itself, instead
[[nodiscard]] TANDEM_EXPORT Curve derivative_curve(const Curve& curve);

}  // namespace v0
}  // namespace tandem
