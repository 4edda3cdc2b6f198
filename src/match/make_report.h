#pragma once

#include "match/search.h"
#include "tandem/match/match.h"
#include "tandem/match/segments.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The report of a programme's path: everything but the times and the validity of the fitted curves.
[[nodiscard]] MatchReport make_report(const Samples& a, const SearchResult& found,
                                      const MatchOptions& options, Layout layout);

/// The same of matched segments.
[[nodiscard]] MatchReport make_report(const SegmentMatch& found, int dim, const MatchOptions& options);

/// MatchReport::shift of a path that starts at this node of m1 and m2.
[[nodiscard]] int shift_of(const Node& first, int m1, int m2);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
