#pragma once

#include "match/limit_slopes.h"
#include "tandem/match/reparametrization.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The three ways to fit v(u); options and path are checked by fit(). `range`: of the slopes, relative to
/// their mean.

/// Order 2 by tolerance: the fewest vertices of the path.
[[nodiscard]] Reparametrization fit_polyline(const FitPath& path, const ReductionOptions& options,
                                             const SlopeRange& range);

/// A number of coefficients: constrained least squares over uniform knots.
[[nodiscard]] Reparametrization fit_coefficients(const FitPath& path, const ReductionOptions& options,
                                                 const SlopeRange& range);

/// Higher orders by tolerance: fit_coefficients from corner to corner, with spans halved until the tolerance
/// holds.
[[nodiscard]] Reparametrization fit_smooth(const FitPath& path, const ReductionOptions& options,
                                           const SlopeRange& range);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
