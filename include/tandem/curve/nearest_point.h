#pragma once

#include <span>

#include "tandem/curve/curve.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// Where a curve comes nearest to a point.
struct NearestPoint {
  double parameter = 0.0;
  double distance = 0.0;
};

/// The point of the curve nearest to `point`; of several that are as near, the one with the smallest
/// parameter.
///
/// Every span is looked at in 32 places per degree, and the lowest of these places are narrowed down to
/// rounding: dips of the distance that are shorter than that, and no deeper than the others, may be missed.
/// @throws InvalidArgument point.size() != curve.dim(), or a number that is not finite
[[nodiscard]] TANDEM_EXPORT NearestPoint nearest_point(const Curve& curve, std::span<const double> point);

}  // namespace v0
}  // namespace tandem
