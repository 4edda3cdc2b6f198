#include "morph/length_center.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "match/vector.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace {

// Chords per span: the centre need not be exact, only the same for a curve and its copies.
constexpr int kChords = 8;

struct Chord {
  double length;
  Point middle;
};

void add_chords(std::vector<Chord>& chords, const Curve& curve) {
  const std::vector<Knot> knots = distinct_knots(curve.knots());
  Point from = curve.evaluate(curve.domain().lo);
  for (std::size_t k = 1; k < knots.size(); ++k) {
    const double lo = std::max(knots[k - 1].value, curve.domain().lo);
    const double hi = std::min(knots[k].value, curve.domain().hi);
    for (int i = 1; i <= kChords && hi > lo; ++i) {
      const Point to = curve.evaluate(i == kChords ? hi : lo + (hi - lo) * i / kChords);
      Chord chord{detail::distance(from, to), from};
      for (std::size_t c = 0; c < to.size(); ++c) chord.middle[c] = 0.5 * from[c] + 0.5 * to[c];
      chords.push_back(std::move(chord));
      from = to;
    }
  }
}

}  // namespace

Point length_center(std::span<const Curve> curves) {
  std::vector<Chord> chords;
  for (const Curve& curve : curves) {
    if (curve.extent() > 0.0) add_chords(chords, curve);
  }
  // Lengths relative to the longest, whose sum is finite.
  double longest = 0.0;
  for (const Chord& chord : chords) longest = std::max(longest, chord.length);
  if (!(longest > 0.0)) return curves.front().evaluate(curves.front().domain().lo);
  double total = 0.0;
  for (const Chord& chord : chords) total += chord.length / longest;
  Point center(static_cast<std::size_t>(curves.front().dim()));
  for (const Chord& chord : chords) {
    const double share = chord.length / longest / total;
    for (std::size_t c = 0; c < center.size(); ++c) center[c] += share * chord.middle[c];
  }
  return center;
}

}  // namespace v0
}  // namespace tandem
