#pragma once

#include <span>
#include <vector>

#include "match/segment_arcs.h"
#include "tandem/match/cost_table.h"
#include "tandem/progress.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The best path through the joints, or none.
struct SegmentPath {
  std::vector<Node> nodes;  ///< none: every path costs more than `most`
  double cost = 0.0;
  bool cancelled = false;
};

/// Drops the arcs of the list that miss a pin: paths along the others meet all of them. pins: pairs of
/// joints, by row and column; modulo the sizes where those are cyclic.
void keep_to_pins(SegmentArcs& arcs, std::span<const Node> pins);

/// The optimal path over the listed arcs that costs no more than `most`.
///
/// Two open paths: (0,0) -> (rows, cols). Only the rows cyclic: (k,0) -> (k + rows, cols) over all k. Both:
/// over all starts; a closed path may jump over column 0, so its first node is (k,-p), the last one before
/// column 1, with 0 <= p < the longest jump.
/// Exact: branch and bound. A programme from many starts at once bounds the cost of every one of them from
/// below; the starts that the bound does not sort out are halved until each is certain. Arcs that the bounds
/// sort out are dropped from the list.
[[nodiscard]] SegmentPath best_segment_path(SegmentArcs& arcs, double most, const Progress& progress);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
