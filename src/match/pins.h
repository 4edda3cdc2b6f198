#pragma once

#include <vector>

#include "match/search.h"
#include "tandem/curve/curve.h"
#include "tandem/match/match.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The options with their pins inside the domains, by u, each once; and with the direction that they fix, if
/// they fix one.
/// @throws InvalidArgument a pin outside the domains; no path in the directions allowed runs through all
[[nodiscard]] MatchOptions settle_pins(const Curve& a, const Curve& b, MatchOptions options, Layout layout);

/// A stretch of both curves that belongs together; on a loop it may run past the end. Of a reversed curve v
/// falls.
struct PinnedStretch {
  Interval u;
  Interval v;  ///< lo <= hi, as the curve has it
};

/// The stretches between consecutive (settled) pins, and on open curves those to the ends. Where one loop is
/// cut, the last one is what lies beyond the pins: of the open curve it holds both ends, so that lo > hi.
[[nodiscard]] std::vector<PinnedStretch> stretches(const MatchOptions& options, Layout layout,
                                                   const Interval& domain_a, const Interval& domain_b,
                                                   bool reversed);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
