#pragma once

#include <vector>

#include "tandem/match/match.h"
#include "tandem/morph/blend.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Whether other ways of matching may stand in for the caller's own: for the default only, what a caller asks
/// for is what is done.
[[nodiscard]] bool may_vary(const MatchOptions& options);

/// The ways of matching to be tried, the caller's own among them. In a hurry (coarse_to_fine), first the one
/// that helps most, on few samples.
[[nodiscard]] std::vector<MatchOptions> variants_of(const MatchOptions& own);

/// The blends to be tried for one that is asked for.
[[nodiscard]] std::vector<BlendKind> kinds_of(BlendKind kind);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
