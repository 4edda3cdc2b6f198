#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "match/found_match.h"
#include "morph/planar_frame.h"
#include "morph/step_blend.h"
#include "tandem/curve/curve.h"
#include "tandem/match/match.h"
#include "tandem/morph/blend.h"
#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Two contours that are matched.
struct MatchedPair {
  Curve a;
  Curve b;
  FoundMatch found;

  /// The whole match: for what has been chosen, it takes its time.
  [[nodiscard]] Match finish() const { return finish_match(a, b, found); }
};

/// What becomes of a contour, or of a piece of one, in a step. Several may be pieces of the same contour.
struct FoundContour {
  std::optional<std::size_t> a;        ///< of the first key; nothing: born
  std::optional<std::size_t> b;        ///< of the second; nothing: dies
  std::shared_ptr<MatchedPair> match;  ///< shared by copies; nothing: born or dies
  std::vector<double> cuts;  ///< where the first key's contour is cut; empty: nowhere, or there is none
  ContourEnds ends;          ///< what is blended: pieces with their chords
  ContourDetour detour;
  /// Of pieces: as they are drawn at the ends, see CutPiece::outline.
  std::optional<CubicPath> outline_a = {};
  std::optional<CubicPath> outline_b = {};

  [[nodiscard]] bool is_piece() const noexcept { return outline_a || outline_b; }
  /// What is drawn at the ends.
  [[nodiscard]] ContourEnds drawn() const {
    return {outline_a ? *outline_a : ends.a, outline_b ? *outline_b : ends.b};
  }
};

/// One correspondence of all contours, and the frame it is blended in.
struct StepCandidate {
  PlanarFrame frame;
  std::vector<FoundContour> contours;
  /// How far the correspondence is from its mirror image, in shares of the length, where contours are
  /// mirror-symmetric about axes that are parallel; 0 where none are.
  double asymmetry = 0.0;

  [[nodiscard]] std::vector<ContourEnds> ends() const;
  [[nodiscard]] StepBlend blend(BlendKind kind) const;
};

/// The candidate with its segments cut until none is longer than `longest`, a share of its contour's length:
/// short enough for the contour to be bent.
[[nodiscard]] StepCandidate subdivided(StepCandidate candidate, double longest);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
