#include "rank/variant.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Mirrored: the first coordinate changes its sign. Reversed: the chords in the other order, each backwards.
Points arranged(const Points& tangents, bool mirrored, bool reversed) {
  Points result = tangents;
  const std::size_t m = tangents.size();
  for (std::size_t i = 0; i < m; ++i) {
    const auto from = tangents[reversed ? m - 1 - i : i];
    const auto to = result[i];
    for (std::size_t c = 0; c < to.size(); ++c)
      to[c] = (reversed != (mirrored && c == 0)) ? -from[c] : from[c];
  }
  return result;
}

std::vector<double> mean_tangents(const Points& tangents, const std::vector<double>& lengths) {
  const auto dim = static_cast<std::size_t>(tangents.dim());
  constexpr auto kCount = static_cast<std::size_t>(kStretches);
  std::vector<double> means(dim * kCount, 0.0);
  double at = 0.0;  // in stretches
  std::size_t stretch = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    double left = lengths[i] * static_cast<double>(kStretches);
    while (left > 0.0) {
      const double room = static_cast<double>(stretch + 1) - at;
      // Rounding may leave a little behind the last stretch, which takes it.
      const double part = stretch + 1 < kCount ? std::min(left, room) : left;
      for (std::size_t c = 0; c < dim; ++c) means[c * kCount + stretch] += part * tangents[i][c];
      at += part;
      left -= part;
      if (part == room && stretch + 1 < kCount) {
        ++stretch;
        at = static_cast<double>(stretch);
      }
    }
  }
  return means;
}

}  // namespace

Variant make_variant(const ShapeDescriptor& shape, bool mirrored, bool reversed,
                     const CompareOptions& options) {
  Variant v;
  v.mirrored = mirrored;
  v.reversed = reversed;
  v.tangents = mirrored || reversed ? arranged(shape.tangents(), mirrored, reversed) : shape.tangents();
  v.lengths = shape.lengths();
  if (reversed) std::reverse(v.lengths.begin(), v.lengths.end());
  if (options.rotate && shape.dim() > 1) v.stretches = mean_tangents(v.tangents, v.lengths);
  if (shape.dim() == 2) {
    const bool by_length = options.cost == RankCost::elastic;
    v.bound = DirectionBound(v.tangents, by_length ? v.lengths : std::vector<double>(v.tangents.size(), 1.0));
  }
  return v;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
