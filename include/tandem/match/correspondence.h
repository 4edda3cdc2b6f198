#pragma once

#include <vector>

#include "tandem/curve/interval.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// A pair of parameters that belong together.
struct ParameterPair {
  double u = 0.0;
  double v = 0.0;
  friend bool operator==(const ParameterPair&, const ParameterPair&) = default;
};

/// The monotone path (u(t), v(t)) that puts two curves in step: the symmetric result of a match.
///
/// `points` are in the curves' own domains, u never decreasing, v never decreasing (never increasing when
/// `reversed`). On closed curves both run on past the end instead of wrapping: the last point is the first
/// plus (or minus) one period each. Between the points the correspondence is linear.
struct TANDEM_EXPORT Correspondence {
  std::vector<ParameterPair> points;
  Interval domain_u;
  Interval domain_v;
  bool closed = false;
  bool reversed = false;

  /// v that belongs to u, and back. Open: clamped to the domains. Closed: any u; v runs on with it, period by
  /// period. Where the path stands still the middle of the jump is taken.
  [[nodiscard]] double v_at(double u) const;
  [[nodiscard]] double u_at(double v) const;
  /// The same correspondence with the curves exchanged.
  [[nodiscard]] Correspondence inverse() const;
};

}  // namespace v0
}  // namespace tandem
