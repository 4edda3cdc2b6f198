#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "morph/contour_pairs.h"
#include "tandem/match/rotation.h"
#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A contour of a key, or a piece of one.
struct KeyPart {
  CubicPath path;
  std::size_t source = 0;                 ///< the contour of the key that it is, or is a piece of
  std::optional<CubicPath> outline = {};  ///< of a piece, see CutPiece::outline
};

/// Both keys of a step, where solids that several of the other key are made from are cut into pieces.
struct CutKeys {
  std::vector<KeyPart> a;
  std::vector<KeyPart> b;
};

/// Cuts solids along inner chords into as many pieces as the other key wants of them (spec B2): each solid
/// that `pairs` leaves without a partner goes to the one that is nearest to it in the drawing, seen turned by
/// `turn`. Pieces have the shares of area, and about the places, of those they become. Nothing when there is
/// nothing to be cut, or no way to do it.
/// a, b: consistently wound, see orient()
[[nodiscard]] std::optional<CutKeys> cut_keys(std::span<const CubicPath> a, std::span<const CubicPath> b,
                                              std::span<const ContourPair> pairs, const Rotation& turn);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
