#pragma once

#include "match/sample_pair.h"
#include "match/search.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Runs the programmes on `coarse`, fewer samples of the same curves, and then on `fine` beside the path that
/// they found, in the direction that they found: not exact.
[[nodiscard]] SearchResult search_near(const SamplePair& coarse, const SamplePair& fine, MatchOptions options,
                                       Layout layout, EdgePlans* plans = nullptr);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
