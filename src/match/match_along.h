#pragma once

#include "tandem/match/correspondence.h"
#include "tandem/match/match.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The match of a and b along another correspondence of theirs: with its reparametrisation, its curve, and
/// their validity. The rest of the report is that of `found`, match(a, b, options).
[[nodiscard]] Match match_along(const Curve& a, const Curve& b, const MatchOptions& options, Match found,
                                Correspondence along);

/// match(b, a, options) from match(a, b, options), which is `found`, without a search; options without a
/// rotation, which the match has.
[[nodiscard]] Match inverse_match(const Curve& a, const Curve& b, const MatchOptions& options, Match found);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
