#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tandem/match/match.h"
#include "tandem/match/rotation.h"
#include "tandem/morph/morph.h"
#include "tandem/shape/shape.h"

namespace tandem {
inline namespace v0 {

/// All contours through all keys: per contour curves of one degree, knot vector, weights and domain.
struct InStep {
  std::vector<std::vector<Curve>> contours;                ///< [contour][key]
  std::vector<std::vector<std::optional<Match>>> matches;  ///< [key][contour], where both keys have it
  std::vector<Rotation> rotations;                         ///< from each key to the next
  bool cancelled = false;                                  ///< the rest is meaningless
};

/// Matches each key's contours with the already reparametrised ones of the key before it (spec C14), under
/// one turn for all contours (spec C11).
///
/// keys: at least two, of one dimension, none empty. Where a contour is missing, or is a mere point, it is
/// collapsed: onto the box centre of the nearest key that has it, or onto that point. one_direction: the
/// closed contours of a key are all reversed or none is, as the nonzero fill rule needs it: it tells holes by
/// their direction. The larger part of the length decides.
[[nodiscard]] InStep put_in_step(std::span<const Shape> keys, bool one_direction,
                                 const MorphOptions& options);

}  // namespace v0
}  // namespace tandem
