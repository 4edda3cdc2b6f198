#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "tandem/morph/blend.h"
#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The in-betweens of two planar paths with the same segments, as control points.
class ContourBlend {
 public:
  ContourBlend() = default;
  ContourBlend(const ContourBlend&) = delete;
  ContourBlend& operator=(const ContourBlend&) = delete;
  virtual ~ContourBlend() = default;

  /// Coordinates as in Points::data(): the first path's at s = 0, the second's at s = 1, up to rounding; any
  /// finite s.
  virtual void at(double s, std::span<double> points) const = 0;
  /// Whether at(s) is (1 - s) a + s b.
  [[nodiscard]] virtual bool is_linear() const { return false; }
  /// Whether segment i, a straight line in both paths, is one all the way.
  [[nodiscard]] virtual bool keeps_line([[maybe_unused]] std::size_t i) const { return true; }
};

/// kind: affine, hermite or intrinsic.
[[nodiscard]] std::unique_ptr<const ContourBlend> make_contour_blend(BlendKind kind, const CubicPath& a,
                                                                     const CubicPath& b);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
