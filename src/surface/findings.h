#pragma once

#include <array>
#include <optional>

#include "surface/boundary.h"
#include "tandem/surface/certificate.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A pair of parameters, u first.
using Parameters = std::array<double, 2>;

/// A certificate before its points are evaluated.
struct Findings {
  Verdict regular = Verdict::undecided;
  std::optional<Verdict> one_to_one;
  std::optional<WitnessKind> witness;
  std::array<Parameters, 2> places{};
  std::array<int, 2> signs{};  ///< of the Jacobian at the places, where they were proved

  void sign_change(const Parameters& rarer, int sign, const Parameters& other) {
    regular = Verdict::violated;
    one_to_one = Verdict::violated;
    witness = WitnessKind::sign_change;
    places = {rarer, other};
    signs = {sign, -sign};
  }
  void zero(const Parameters& place) {
    regular = Verdict::violated;
    witness = WitnessKind::zero;
    places = {place, place};
  }
  /// What a boundary says of a map whose Jacobian is positive (or negative) inside, or not known to be.
  ///
  /// Why a regular map with a simple boundary is one-to-one. Let the Jacobian be positive inside. Away from
  /// the image of the boundary, a point is met as often as the boundary winds about it (every place counts
  /// +1): once inside a simple closed curve and never outside, so no point is met twice. A place inside
  /// cannot lie on the curve, since its neighbourhood would reach outside. For a closed surface, a ring, both
  /// curves are simple and disjoint. They are nested: two disks beside each other would both be covered, and
  /// nothing between them. They run the same way round: otherwise the inner disk would be covered twice, by
  /// two disks, and the space between once, and the Euler characteristic of the ring would be 2 rather than
  /// 0. What is left is that the space between is covered once. Creases do no harm as long as the Jacobian is
  /// positive on both sides, nor do zeros on the boundary. Conversely, a map whose Jacobian takes both signs
  /// is not one-to-one (an injective map of a plane region has one local degree).
  void boundary(const SimpleBoundary& found, bool sign_is_known) {
    one_to_one = Verdict::undecided;
    if (found.verdict == Verdict::certified && sign_is_known) one_to_one = Verdict::certified;
    if (found.verdict != Verdict::violated) return;
    one_to_one = Verdict::violated;
    if (witness) return;
    witness = WitnessKind::crossing;
    for (std::size_t i = 0; i < 2; ++i) {
      const BoundaryPlace& place = found.places[i];
      places[i] = place.edge->along == Along::u ? Parameters{place.t, place.edge->fixed}
                                                : Parameters{place.edge->fixed, place.t};
    }
  }
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
