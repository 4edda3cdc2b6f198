#pragma once

namespace tandem {
inline namespace v0 {

/// The largest coordinate, knot or time that the readers take: far from overflow, so that differences and
/// boxes stay finite.
inline constexpr double kLargestCoordinate = 1e300;

/// The largest degree taken from a file: beyond it evaluation is only a way to spend time.
inline constexpr int kLargestDegree = 1000;

}  // namespace v0
}  // namespace tandem
