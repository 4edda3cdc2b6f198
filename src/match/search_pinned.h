#pragma once

#include "match/search.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// search() with pins: the samples have nodes at all of them. Programmes run on the stretches between
/// consecutive pins, which are open; their lexicographic costs add up, so the sum of their optima is the
/// optimum of the paths through the pins. A loop that is matched with an open curve is tried with every cut
/// beyond the pins.
[[nodiscard]] SearchResult search_pinned(const Samples& a, const Samples& b, const MatchOptions& options,
                                         Layout layout);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
