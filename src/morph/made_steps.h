#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "morph/step_search.h"
#include "tandem/morph/morph.h"
#include "tandem/morph/path_morph.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A step of a morph that has been made between two keys.
struct MadeStep {
  std::vector<std::optional<CubicPath>> firsts;  ///< by tracks: the first key's contours as they were matched
  BlendKind kind = BlendKind::affine;
  PlanarFrame frame;
  std::vector<ContourStep> contours;   ///< by tracks
  std::vector<ContourDetour> detours;  ///< by tracks
};

/// A key as it was given.
struct GivenKey {
  std::vector<CubicPath> contours;
  Vec2 center;
  friend bool operator==(const GivenKey&, const GivenKey&) = default;
};

/// Which step it was, and whether it was made the other way round.
struct Again {
  std::size_t step;
  bool back;
};

/// The first of the steps between keys 0, 1, 2, ... that was made between the last key and the `next` one,
/// one way or the other. can_start: whether the contours of the last key have the joints of those of this
/// one.
template <typename CanStart>
[[nodiscard]] std::optional<Again> find_again(std::span<const GivenKey> keys, const GivenKey& next,
                                              const CanStart& can_start) {
  for (std::size_t j = 0; j + 1 < keys.size(); ++j) {
    if (keys[j + 1] == next && keys[j] == keys.back() && can_start(j)) return Again{j, false};
    if (keys[j] == next && keys[j + 1] == keys.back() && can_start(j + 1)) return Again{j, true};
  }
  return std::nullopt;
}

/// The step the other way round. seconds: the contours of its second key, as given
[[nodiscard]] MadeStep reversed(MadeStep step, std::span<const CubicPath> seconds,
                                const MatchOptions& options);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
