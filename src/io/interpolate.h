#pragma once

#include <vector>

#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {

/// The cubic spline through points[i] at times[i]: C2, with not-a-knot ends; of degree n - 1 for n < 4
/// points. times: increasing, at least two. The domain is [times.front(), times.back()]. Source: de Boor, A
/// Practical Guide to Splines, chapters IX and XIII.
[[nodiscard]] Curve interpolate(const std::vector<double>& times, const Points& points);

}  // namespace v0
}  // namespace tandem
