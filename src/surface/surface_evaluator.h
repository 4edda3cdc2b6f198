#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tandem/surface/surface.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Evaluates a surface many times without allocating (but for high degrees and orders). Looks at the surface,
/// which must outlive it; holds no state between calls, so threads may share one. Parameters are clamped.
class SurfaceEvaluator {
 public:
  explicit SurfaceEvaluator(const Surface& surface) noexcept : surface_(surface) {}

  /// The point, dim numbers.
  void point(double u, double v, std::span<double> p) const;

  /// Rows as in Surface::derivatives(): (order + 1)(order + 2) / 2 times dim numbers.
  void derivatives(double u, double v, int order, SurfaceSides sides, std::span<double> rows) const;

 private:
  const Surface& surface_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
