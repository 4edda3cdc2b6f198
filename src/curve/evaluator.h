#pragma once

#include <cstddef>
#include <span>

#include "tandem/curve/curve.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Evaluates a curve many times without allocating (degrees up to 31; higher ones allocate per call).
///
/// Looks at the curve, which must outlive it; holds no state between calls, so threads may share one.
/// Everything is a convex combination of control points or of their differences: values stay in the hull, and
/// a curve far from the origin loses no more digits than its coordinates have lost already. Derivatives too
/// large for a double are cut off at the largest double; nothing is ever NaN for a parameter that is not.
/// (Exported for the benchmarks, which measure it alone; not part of the public interface.)
class TANDEM_EXPORT Evaluator {
 public:
  explicit Evaluator(const Curve& curve) noexcept;

  [[nodiscard]] int dim() const noexcept { return dim_; }
  [[nodiscard]] int degree() const noexcept { return degree_; }
  [[nodiscard]] Interval domain() const noexcept { return domain_; }

  /// The point at t (clamped to the domain) into p, dim() numbers.
  void point(double t, std::span<double> p) const;

  /// Point and first derivative at t (clamped to the domain), dim() numbers each; at a knot `side` decides.
  void point_and_derivative(double t, Side side, std::span<double> p, std::span<double> d) const;

  /// Derivatives 0..order into rows, (order + 1) * dim() numbers, row after row.
  void derivatives(double t, int order, Side side, std::span<double> rows) const;

 private:
  [[nodiscard]] std::size_t span_at(double t, Side side) const noexcept;

  const double* knots_;
  const double* points_;
  const double* weights_;  ///< null for a polynomial curve
  std::size_t size_;
  int degree_;
  int dim_;
  Interval domain_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
