#include "match/pinned_path.h"

#include <algorithm>
#include <cmath>

#include "tandem/shape/cut_at.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// A pin that is nearer than this to a joint, in parameter, is that joint: nearest_point() does not tell them
/// apart, and a segment so short would be one in name only.
constexpr double kAtJoint = 1e-6;

}  // namespace

SegmentPiece PinnedPath::original(const SegmentPiece& piece) const {
  const double from = joints[piece.segment];
  const double to = joints[piece.segment + 1];
  const double segment = std::floor(from);
  const auto local = [&](double t) {
    if (t == 0.0) return from - segment;
    if (t == 1.0) return to - segment;
    return (1.0 - t) * (from - segment) + t * (to - segment);
  };
  return {static_cast<std::size_t>(segment), local(piece.from), local(piece.to)};
}

PinnedPath split_at_pins(const CubicPath& path, std::span<const double> pins, bool loop) {
  PinnedPath result{path, {}, {}};
  for (std::size_t i = 0; i <= path.segment_count(); ++i) result.joints.push_back(static_cast<double>(i));
  const auto near = [&](double pin) {
    return std::find_if(result.joints.begin(), result.joints.end(),
                        [&](double joint) { return std::fabs(joint - pin) <= kAtJoint; });
  };
  for (const double pin : pins) {
    if (near(pin) != result.joints.end()) continue;
    result.joints.insert(std::upper_bound(result.joints.begin(), result.joints.end(), pin), pin);
  }
  const std::size_t segments = result.joints.size() - 1;
  for (const double pin : pins) {
    const auto joint = static_cast<std::size_t>(near(pin) - result.joints.begin());
    result.pins.push_back(loop ? joint % segments : joint);
  }
  if (segments > path.segment_count()) result.path = cut_at(path, result.joints, path.is_closed());
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
