#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "surface/bernstein_enclosure.h"
#include "surface/enclosed_surface.h"
#include "surface/findings.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A part of a surface with the polynomials that decide about it.
struct CellPiece {
  std::vector<BernsteinGrid> normal;
  Cell cell;

  [[nodiscard]] Parameters middle() const noexcept {
    return {0.5 * cell[0].lo + 0.5 * cell[0].hi, 0.5 * cell[1].lo + 0.5 * cell[1].hi};
  }
  /// Places are doubles; a cell narrower than a few of them has no place of its own.
  [[nodiscard]] bool can_split(std::size_t along) const noexcept {
    const double at = middle()[along];
    return cell[along].lo < at && at < cell[along].hi;
  }
  /// Halved where the polynomials vary more.
  [[nodiscard]] std::vector<CellPiece> halves() const;
};

/// One piece for each patch between knots.
[[nodiscard]] std::vector<CellPiece> whole_patches(const EnclosedSurface& surface);

/// Goes through a surface level by level, halving what is not decided: decide(piece) returns whether it is,
/// enough(depth) whether nothing more is to be asked. False if pieces remained undecided.
template <class Decide, class Enough>
bool search_cells(const EnclosedSurface& surface, Decide decide, Enough enough) {
  // 2^-30 of a patch in either direction: rounding errors decide nothing below that.
  constexpr int kLargestDepth = 60;
  // For surfaces that are nearly singular along a curve.
  constexpr int kMostPieces = 20000;
  bool all = true;
  int pieces = 0;
  std::vector<CellPiece> level = whole_patches(surface);
  for (int depth = 0; !level.empty() && !enough(depth); ++depth) {
    std::vector<CellPiece> next;
    for (const CellPiece& piece : level) {
      if (decide(piece)) continue;
      std::vector<CellPiece> parts;
      if (depth < kLargestDepth && ++pieces <= kMostPieces) parts = piece.halves();
      if (parts.empty()) all = false;
      for (CellPiece& part : parts) next.push_back(std::move(part));
    }
    level = std::move(next);
  }
  return all;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
