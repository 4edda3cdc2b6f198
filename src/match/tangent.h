#pragma once

#include <span>

#include "curve/evaluator.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The unit tangent at t from one side: the direction of the first derivative that does not vanish (seen from
/// the left, those of even order point backwards). Zero where the curve stands still on that side. extent:
/// size of the curve; derivatives of order k below 1e-12 * extent / (length of the domain)^k are none.
/// @returns the speed |C'(t)|
double one_sided_tangent(const Evaluator& curve, double t, Side side, double extent,
                         std::span<double> tangent);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
