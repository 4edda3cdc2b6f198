#pragma once

#include <vector>

#include "tandem/match/match.h"
#include "tandem/match/programme.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The sum of y x^T over the tangents x of a and y of b that a path matches, row-major dim x dim, each pair
/// with the weight that the programme gives its cost: chords by the length under which they run together
/// (elastic), nodes alike (paper). The rotation nearest to it is the best one for this path.
[[nodiscard]] std::vector<double> matched_covariance(const Samples& a, const Samples& b, const Path& path,
                                                     Method method);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
