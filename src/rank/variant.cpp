#include "rank/variant.h"

#include <algorithm>
#include <cstddef>

#include "match/vector.h"
#include "rank/tangent_planes.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Mirrored: the first coordinate changes its sign. Reversed: the chords in the other order, each backwards.
TangentPlanes arranged(TangentPlanes tangents, bool mirrored, bool reversed) {
  for (std::size_t c = 0; c < tangents.planes.size(); ++c) {
    std::vector<double>& plane = tangents.planes[c];
    if (reversed) std::reverse(plane.begin(), plane.end());
    if (reversed == (mirrored && c == 0)) continue;
    for (double& x : plane) x = -x;
  }
  return tangents;
}

/// The directions of kStretches equally long stretches. One that leads back to its start has none; it takes
/// the direction of the one before.
TangentPlanes equal_stretches(const TangentPlanes& tangents, const std::vector<double>& lengths) {
  constexpr auto kCount = static_cast<std::size_t>(kStretches);
  const std::size_t dim = tangents.planes.size();
  Points sums(static_cast<int>(dim), kCount);
  double at = 0.0;  // in stretches
  std::size_t stretch = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    double left = lengths[i] * static_cast<double>(kStretches);
    while (left > 0.0) {
      const double room = static_cast<double>(stretch + 1) - at;
      // Rounding may leave a little behind the last stretch, which takes it.
      const bool last = stretch + 1 == kCount;
      const double part = last ? left : std::min(left, room);
      for (std::size_t c = 0; c < dim; ++c) sums[stretch][c] += part * tangents.planes[c][i];
      left -= part;
      at += part;
      if (!last && part == room) at = static_cast<double>(++stretch);
    }
  }
  for (std::size_t lap = 0; lap < 2 * kCount; ++lap) {
    const std::size_t k = lap % kCount;
    if (normalize(sums[k]) > 0.0) continue;
    const auto before = sums[(k + kCount - 1) % kCount];
    std::copy(before.begin(), before.end(), sums[k].begin());
  }
  return to_planes(sums);
}

}  // namespace

std::vector<double> node_weights(const std::vector<double>& lengths, const CompareOptions& options) {
  return options.cost == RankCost::elastic ? lengths : std::vector<double>(lengths.size(), 1.0);
}

Variant make_variant(const ShapeDescriptor& shape, bool mirrored, bool reversed,
                     const CompareOptions& options) {
  Variant v;
  v.mirrored = mirrored;
  v.reversed = reversed;
  v.tangents = arranged(to_planes(shape.tangents()), mirrored, reversed);
  v.lengths = shape.lengths();
  if (reversed) std::reverse(v.lengths.begin(), v.lengths.end());
  if (options.rotate && shape.dim() > 1) {
    v.coarse = equal_stretches(v.tangents, v.lengths);
    v.coarse_lengths.assign(static_cast<std::size_t>(kStretches), 1.0 / kStretches);
  }
  if (shape.dim() == 2) v.bound = DirectionBound(v.tangents, node_weights(v.lengths, options));
  return v;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
