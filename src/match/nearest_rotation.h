#pragma once

#include <span>

#include "tandem/match/rotation.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The rotation that fits a sum of pairs best, and how well.
struct NearestRotation {
  Rotation rotation;
  double score = 0.0;  ///< the sum of <R x, y> over the pairs
};

/// The rotation R that makes the sum of <R x, y> over pairs of vectors largest (Procrustes, Kabsch).
/// covariance: the sum of y x^T, row-major dim x dim. Where the pairs leave a freedom (fewer than dim - 1
/// directions among them), the smaller turn is taken. The identity for a covariance of nothing.
[[nodiscard]] NearestRotation nearest_rotation(std::span<const double> covariance, int dim);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
