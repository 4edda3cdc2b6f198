#pragma once

#include <cstddef>
#include <vector>

#include "tandem/match/correspondence.h"
#include "tandem/match/cost_table.h"
#include "tandem/match/match.h"
#include "tandem/match/segment_rules.h"
#include "tandem/progress.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

struct SegmentOptions {
  SegmentSplit split = SegmentSplit::proportional;
  SegmentCost cost = SegmentCost::derivative;
  /// The most segments that one may meet; 0: any number.
  int longest_run = 0;
  Direction direction = Direction::automatic;
  /// automatic: two closed paths meet at the best pair of joints; one closed path is cut where that is best.
  /// `pinned` is none of this method's.
  ClosedMode closed = ClosedMode::automatic;
  /// Pairs of points that belong together: parameters of to_curve() of the two paths. Segments are split
  /// there first (exactly; within 1e-6 of a joint it is the joint that is meant), and the match is the
  /// optimum among the paths through those nodes.
  std::vector<ParameterPair> pins = {};
  Progress progress = {};
};

/// The part of a segment of an input that an output segment redraws: from > to where it runs backwards.
struct SegmentPiece {
  std::size_t segment = 0;
  double from = 0.0;  ///< parameter within the segment, in [0, 1]
  double to = 1.0;
  friend bool operator==(const SegmentPiece&, const SegmentPiece&) = default;
};

/// Two cubic paths in step: the same curves, redrawn with the same number of segments.
struct SegmentMatch {
  /// The first path, from its own start joint (cut open: from the cut).
  CubicPath a;
  /// The second path, from the point that belongs to that joint; run through backwards where reversed.
  CubicPath b;
  std::vector<SegmentPiece> pieces_a;  ///< where the segments of `a` come from
  std::vector<SegmentPiece> pieces_b;
  double cost = 0.0;
  Direction direction = Direction::forward;
  int shift = 0;  ///< in joints of the second path, as MatchReport::shift
  /// The pairs of joints (points of pins are joints, too) that were matched: those of the first path and of
  /// the second one as run through (from its end where reversed). Loops: from the first pair at or after the
  /// first path's start, once round, so that the last is the first plus (m, n).
  std::vector<Node> path = {};
  /// In parameters of to_curve() of the inputs: one point per joint of the output. Linear between, as the
  /// programme has it.
  Correspondence correspondence = {};
  bool cancelled =
      false;  ///< the progress callback said stop: a and b are the inputs, the rest means nothing
};

/// Finds the best matching of the segments of b to those of a ([D] section 4, spec D4 to D6), in R^n.
///
/// Pairs of joints are the nodes of a programme; an edge leads over one segment of either path and over k of
/// the other. Exact: the optimum over all such paths, for closed curves over all starts too, also those at
/// which an edge skips a joint (branch and bound). Forward on a tie. Symmetric: match_segments(b, a) is the
/// same match, with the curves exchanged.
///
/// For m and n segments there are m n (m + n) edges; those that cost more than a whole matching are sorted
/// out unseen where the lengths tell. Closed paths take as many programmes as the search needs.
/// @throws InvalidArgument the dimensions differ, an open path where ClosedMode wants closed ones, `pinned`,
/// longest_run is negative or too small for the numbers of segments, pins outside of the paths or such that
/// no path runs through all of them
[[nodiscard]] TANDEM_EXPORT SegmentMatch match_segments(const CubicPath& a, const CubicPath& b,
                                                        const SegmentOptions& options = {});

}  // namespace v0
}  // namespace tandem
