#include <cstddef>
#include <utility>
#include <vector>

#include "tandem/match/rotation.h"

namespace tandem {
inline namespace v0 {
namespace {

/// The mean over the length, of the polygon of nodes.
std::vector<double> center_of(const Samples& s) {
  std::vector<double> center(static_cast<std::size_t>(s.dim()));
  for (std::size_t k = 0; k < s.chords(); ++k) {
    const auto from = s.positions[k];
    const auto to = s.positions[(k + 1) % s.size()];
    const double half = 0.5 * s.chord_lengths[k];
    for (std::size_t c = 0; c < center.size(); ++c) center[c] += half * from[c] + half * to[c];
  }
  return center;
}

}  // namespace

Samples turned(Samples s, const Rotation& rotation) {
  if (rotation.is_identity()) return s;
  s.tangents_in = rotation(std::move(s.tangents_in));
  s.tangents_out = rotation(std::move(s.tangents_out));
  s.chord_tangents = rotation(std::move(s.chord_tangents));
  const std::vector<double> center = center_of(s);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const auto point = s.positions[i];
    for (std::size_t c = 0; c < center.size(); ++c) point[c] -= center[c];
    rotation.apply(point, point);
    for (std::size_t c = 0; c < center.size(); ++c) point[c] += center[c];
  }
  return s;
}

}  // namespace v0
}  // namespace tandem
