#pragma once

#include <functional>

#include "tandem/match/norm.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// What a norm says of one pair of points of two rails, as refine_path() looks at it.
struct RailValue {
  double cost = 0.0;   ///< >= 0
  double value = 1.0;  ///< > 0 where the pair is valid
};
using RailNorm = std::function<RailValue(const NormArguments&)>;

/// Rails in space: the anti-twist form of the ruled norm (spec C13) is the cost, and pairs with <T1,T2> < 0,
/// whose in-betweens may turn back ([C] Lemma 1), are invalid.
[[nodiscard]] UserNorm space_norm();
[[nodiscard]] RailNorm space_rail_norm();

/// Rails in the plane: the signed ruled test (spec C13), sigma = +1 or -1.
[[nodiscard]] RailNorm planar_rail_norm(double sigma);

/// developable_norm(), with the smaller of the two margins (of warp and of inclination) as the value.
[[nodiscard]] RailNorm developable_rail_norm(double largest_inclination);

/// <T1,T2>.
[[nodiscard]] RailNorm tangent_rail_norm();

}  // namespace detail
}  // namespace v0
}  // namespace tandem
