#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "surface/contour_rings.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A contour of one level that goes on in one of the next.
struct ContourLink {
  std::size_t below = 0;
  std::size_t above = 0;
};

/// The links between two levels; of two linked contours at most one has several links. See
/// contours_to_solid().
[[nodiscard]] std::vector<ContourLink> link_levels(std::span<const Ring> below, std::span<const Ring> above,
                                                   std::span<const Vec2> places);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
