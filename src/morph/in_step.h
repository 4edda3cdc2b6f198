#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "tandem/match/match.h"

namespace tandem {
inline namespace v0 {

/// One contour through all keys: curves of one degree, knot vector, weights and domain, blended point by
/// point.
struct InStep {
  std::vector<Curve> curves;                  ///< one per key
  std::vector<std::optional<Match>> matches;  ///< of key i with key i + 1, where both have the contour
  bool cancelled = false;
};

/// Matches each key's contour with the already reparametrised one of the key before it (spec C14).
///
/// sources: one per key, null where a key has no such contour; at least one is there. Where it is missing, or
/// is a mere point, the contour is collapsed: onto the box centre of the nearest key that has it, or onto
/// that point. `contour` names it in errors.
[[nodiscard]] InStep put_in_step(const std::vector<const Curve*>& sources, std::size_t contour,
                                 const MatchOptions& options,
                                 const std::function<Progress(std::size_t key)>& progress_of);

}  // namespace v0
}  // namespace tandem
