#pragma once

#include <cstddef>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// Arc length of a curve as a function of the parameter, and its inverse.
///
/// Built once (adaptive Gauss-Legendre per span), then cheap to ask. Keeps its own copy of the curve.
class TANDEM_EXPORT ArcLength {
 public:
  /// accuracy: bound on the error of any length, relative to the whole length. @throws InvalidArgument accuracy <= 0
  explicit ArcLength(Curve curve, double accuracy = 1e-10);

  [[nodiscard]] double length() const noexcept { return lengths_.back(); }
  /// Length from the start of the domain to t (clamped to the domain).
  [[nodiscard]] double length_to(double t) const;
  /// The parameter at which `length` has been travelled (clamped to [0, length()]); the smallest one where the
  /// curve stands still.
  [[nodiscard]] double parameter_at(double length) const;

 private:
  Curve curve_;
  double accuracy_;
  std::vector<double> breaks_;   ///< parameters, from the start to the end of the domain
  std::vector<double> lengths_;  ///< length up to each break
};

/// The length of the whole curve; `accuracy` is relative.
[[nodiscard]] TANDEM_EXPORT double arc_length(const Curve& curve, double accuracy = 1e-10);

}  // namespace v0
}  // namespace tandem
