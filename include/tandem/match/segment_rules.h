#pragma once

namespace tandem {
inline namespace v0 {

/// Where one segment is split that meets k others.
enum class SegmentSplit {
  proportional,  ///< in proportion to the arc lengths of the k segments
  uniform,       ///< at 1/k, 2/k, .. of its parameter ([D] section 4.2)
};

/// What it costs to blend a piece of one segment with another segment.
enum class SegmentCost {
  /// The integral of |a'(t) - b'(t)|^2, one segment and the k that it meets run through in the same unit of
  /// time: does not change when both are subdivided alike (spec D5).
  derivative,
  /// [D] section 4.1: |T0 - T1|^2 + |T1 - T2|^2 + |T2 - T3|^2, T_i = P_i' - P_i, summed over the pieces.
  paper,
};

/// What match_segments() goes by; both as [D] has them: uniform, paper.
struct SegmentRules {
  SegmentSplit split = SegmentSplit::proportional;
  SegmentCost cost = SegmentCost::derivative;
};

}  // namespace v0
}  // namespace tandem
