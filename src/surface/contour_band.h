#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/triangulate_region.h"
#include "tandem/match/match.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {
namespace detail {

struct ContourBand {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double valid_share = 1.0;  ///< Validity::valid_share of the match
};

/// Triangles between two loops, matched in the plane: an edge of either loop belongs to exactly one of them,
/// run through as the lower loop runs, and against the upper one's sense.
[[nodiscard]] ContourBand make_band(const Loop& below, const Loop& above, std::span<const Vec2> places,
                                    const MatchOptions& options);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
