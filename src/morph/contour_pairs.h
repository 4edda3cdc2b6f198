#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "tandem/match/match.h"
#include "tandem/match/rotation.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/nesting.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Contours of the two keys of a step that become one another; one alone has nobody to become.
struct ContourPair {
  std::optional<std::size_t> a;
  std::optional<std::size_t> b;
  double cost = 0.0;  ///< of the two: how little they have in common
};

struct ContourPairing {
  std::vector<ContourPair> pairs;
  double cost = 0.0;  ///< of all pairs, and of the contours that are left
};

/// Pairs the contours of a drawing with those of another by optimal assignment (spec B2): solids with solids,
/// holes with holes of the solids that were paired, strokes with strokes. What a pair costs is its match, how
/// far apart the two lie in their drawings, seen turned by `turn`, and how much they differ in size. Where
/// the drawings have an axis of symmetry in common, contours that are each other's mirror images become such
/// ones if that costs little more. All of a come first, in their order, then what is left of b.
[[nodiscard]] ContourPairing pair_contours(std::span<const CubicPath> a, std::span<const CubicPath> b,
                                           const Rotation& turn, const MatchOptions& options);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
