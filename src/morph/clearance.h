#pragma once

#include <cstddef>
#include <vector>

#include "morph/step_blend.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Finds where a contour has room among the others.
class Clearance {
 public:
  /// The detour that takes `contour` to where it keeps clear of the others at s, no further than needed, and
  /// makes it small enough to fit: a hole inside what is filled, a solid outside.
  [[nodiscard]] ContourDetour find(const StepBlend& blend, std::size_t contour, double s);

 private:
  struct Edge {
    Vec2 from;
    Vec2 to;
  };
  void flatten(const std::vector<double>& points, bool closed);

  std::vector<Edge> edges_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
