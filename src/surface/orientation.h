#pragma once

#include <array>
#include <cstddef>

namespace tandem {
inline namespace v0 {
namespace detail {

using SpacePoint = std::array<double, 3>;

/// The signs below are exact for coordinates that are zero or between kLeastExact and kLargestExact in size.
inline constexpr double kLeastExact = 0x1p-300;
inline constexpr double kLargestExact = 0x1p300;

/// +1 if d lies below the plane of a, b, c, which run counter-clockwise seen from above, -1 above, 0 in it:
/// the sign of the determinant |a - d, b - d, c - d|. In plain arithmetic where its error bound allows it
/// (Shewchuk's first one), else by expansions.
[[nodiscard]] int orientation(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                              const SpacePoint& d) noexcept;

/// +1 if the coordinates x and y of a, b, c run counter-clockwise, -1 clockwise, 0 in a line.
[[nodiscard]] int orientation(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c, std::size_t x,
                              std::size_t y) noexcept;

}  // namespace detail
}  // namespace v0
}  // namespace tandem
