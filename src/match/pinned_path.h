#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/match/segments.h"
#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A path that has joints where its pins are: segments that hold some are split there, exactly.
struct PinnedPath {
  CubicPath path;
  std::vector<double> joints;     ///< of `path`, in the parameters of the path as it was
  std::vector<std::size_t> pins;  ///< per pin: which of the joints it is

  /// What a piece of `path` is of the path as it was.
  [[nodiscard]] SegmentPiece original(const SegmentPiece& piece) const;
};

/// pins: parameters of to_curve(path), inside its domain. loop: the last joint is the first one.
[[nodiscard]] PinnedPath split_at_pins(const CubicPath& path, std::span<const double> pins, bool loop);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
