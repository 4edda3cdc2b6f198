#pragma once

#include <span>

#include "tandem/curve/curve.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// An axis-parallel box of R^n; empty (no corners) when default-constructed.
struct TANDEM_EXPORT Box {
  Point lo;
  Point hi;

  [[nodiscard]] bool empty() const noexcept { return lo.empty(); }
  /// Length of the diagonal, without overflow; 0 when empty.
  [[nodiscard]] double diagonal() const;
  [[nodiscard]] Point center() const;
  void include(std::span<const double> point);
  void include(const Box& box);
};

/// The smallest box around the curve itself (not its control polygon), to rounding.
[[nodiscard]] TANDEM_EXPORT Box bounding_box(const Curve& curve);

}  // namespace v0
}  // namespace tandem
