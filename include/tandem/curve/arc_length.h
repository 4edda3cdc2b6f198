#pragma once

#include <cstddef>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// Arc length of a curve as a function of the parameter, and its inverse.
///
/// Built once (adaptive Gauss-Legendre per span), then cheap to ask. Does not need the curve any longer.
class TANDEM_EXPORT ArcLength {
 public:
  /// accuracy: bound on the error of any length, relative to the whole length. @throws InvalidArgument
  /// accuracy <= 0
  explicit ArcLength(const Curve& curve, double accuracy = 1e-10);

  [[nodiscard]] double length() const noexcept { return lengths_.back() / scale_; }
  /// Length from the start of the domain to t (clamped to the domain).
  [[nodiscard]] double length_to(double t) const;
  /// The parameter at which `length` has been travelled (clamped to [0, length()]); the smallest one where
  /// the curve stands still.
  [[nodiscard]] double parameter_at(double length) const;

 private:
  [[nodiscard]] double speed(std::size_t piece, double x) const;
  [[nodiscard]] double integrate(std::size_t piece, double from, double to) const;
  void divide(std::size_t piece, double whole, double tolerance);

  /// A power of two that brings the curve's size near 1: no square overflows or vanishes.
  double scale_ = 1.0;
  int degree_ = 1;  ///< of the coefficients
  int stride_ = 1;
  bool rational_ = false;
  std::vector<double> piece_breaks_;  ///< the distinct knots
  /// Per Bezier piece: of the hodograph, times binomial coefficients; of a rational curve: its own,
  /// premultiplied.
  std::vector<double> coefficients_;
  std::vector<std::size_t> pieces_;  ///< the piece of each interval
  std::vector<double> locals_;       ///< where each interval starts within its piece, in [0, 1)
  std::vector<double> parameters_;   ///< the same in parameters of the curve, and the end of the domain
  std::vector<double> lengths_;      ///< scaled length up to each of parameters_
};

/// The length of the whole curve; `accuracy` is relative.
[[nodiscard]] TANDEM_EXPORT double arc_length(const Curve& curve, double accuracy = 1e-10);

}  // namespace v0
}  // namespace tandem
