#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tandem/shape/cubic_path.h"
#include "tandem/shape/transform.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// What a piece of a contour should be like.
struct PieceTarget {
  double share = 1.0;          ///< of the area, in proportion to the other pieces' shares
  std::optional<Vec2> center;  ///< where its centroid should be
};

/// How the wishes for a cut are weighed against each other; lengths are in diagonals of the contour's box.
struct CutOptions {
  double length_weight = 1.0;  ///< of the length of the chords
  double share_weight = 2.0;   ///< of the differences of area to the targets, in shares of the contour
  double center_weight = 2.0;  ///< of the distances from the targets' centres, each times its share
  bool outlines = false;       ///< whether to make CutPiece::outline
};

/// A piece of a contour: exact parts of its outline, joined by straight chords.
struct CutPiece {
  CubicPath path;            ///< closed, wound like the contour
  std::vector<bool> chords;  ///< per segment: it is a chord (or a part of one), and not on the outline
  /// CutOptions::outlines: the same segments, where the chords are pushed out onto the contour; a chord has
  /// as many segments as it takes. One piece is the whole contour then, the others are parts of it, forth and
  /// back: filled or stroked, all of them together draw the contour and nothing else. Linear in between, a
  /// chord has both its pieces on the same curve at all times. Between two pieces with holes a chord is not
  /// pushed: it would run over them.
  std::optional<CubicPath> outline = {};
};

/// Cuts a contour into as many pieces as there are targets, along chords inside it; piece i is the one for
/// target i. Empty when there is no such cut: the contour encloses nothing, or no chord fits between the
/// holes.
///
/// The chords run between joints and some 130 points along the outline, at 10 degrees to it or more, and stay
/// clear of the rest of the outline, of each other (a chord may end on another one), and of the holes. The
/// contour is halved again and again, at the chord that costs least in length, area and place; up to four
/// pieces the best three distinct chords are followed each time. So the cut is a good one, not always the
/// best.
/// contour: closed, simple; holes: closed paths inside it, which go to the piece that they lie in.
/// @throws InvalidArgument the paths are not planar or not closed, there are no targets, a share is not > 0,
/// or a weight not >= 0
[[nodiscard]] TANDEM_EXPORT std::vector<CutPiece> cut_contour(const CubicPath& contour,
                                                              std::span<const PieceTarget> targets,
                                                              std::span<const CubicPath> holes = {},
                                                              const CutOptions& options = {});

}  // namespace v0
}  // namespace tandem
