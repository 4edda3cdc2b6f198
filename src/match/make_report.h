#pragma once

#include "match/search.h"
#include "tandem/match/match.h"
#include "tandem/match/segments.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The report of a programme's path: everything but the times, the validity of the fitted curves, and
/// elastic's invalid nodes.
[[nodiscard]] MatchReport make_report(const Samples& a, const SearchResult& found,
                                      const MatchOptions& options, Layout layout);

/// The same of matched segments.
[[nodiscard]] MatchReport make_report(const SegmentMatch& found, int dim, const MatchOptions& options);

/// How many nodes of an elastic path the paper's test calls invalid. b: samples as matched
[[nodiscard]] int count_invalid_nodes(const std::vector<Node>& path, const Samples& a, const Samples& b,
                                      const MatchOptions& options, bool closed);

/// MatchReport::shift of a path that starts at this node of m1 and m2.
[[nodiscard]] int shift_of(const Node& first, int m1, int m2);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
