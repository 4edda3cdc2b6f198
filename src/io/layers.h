#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/svg_parts.h"
#include "tandem/io/look.h"
#include "tandem/morph/path_morph.h"

namespace tandem {
inline namespace v0 {

/// What a picture of the morph shows: the view box of the look, or what holds all in-betweens.
[[nodiscard]] View view_of(const Look& look, const Box& box);

/// What a still picture of the morph at s shows: the same for all s in [0,1], beyond grown to hold `paths`.
[[nodiscard]] View view_at(const PathMorph& morph, const Look& look, double s,
                           std::span<const CubicPath> paths);

/// Contours that are drawn as one path, and how. All formats draw the layers of a morph one over the other.
struct Layer {
  /// "filled", "stroked", "drawn" (both), "growing" (stroked, and a point at some key; "growing2", ...).
  std::string name;
  std::vector<std::size_t> contours;
  std::vector<Style>
      keys;  ///< one per key; neither a fill nor a line comes out of nothing or becomes nothing

  [[nodiscard]] bool fills() const { return keys.front().fill.paints(); }
  [[nodiscard]] bool strokes() const { return keys.front().stroke.paints(); }
};

/// ink: of a morph without styles. @throws InvalidArgument another number of styles than of keys
[[nodiscard]] std::vector<Layer> layers_of(const PathMorph& morph, const Look& look, const View& view,
                                           const Paint& ink);

/// The dark ink of pictures without styles.
[[nodiscard]] Paint ink_paint();

/// The style of a layer at s; beyond the keys that of the nearest.
[[nodiscard]] Style style_at(const Layer& layer, std::span<const double> key_times, double s);

/// The contours of a layer.
template <class T>
[[nodiscard]] std::vector<T> part_of(const Layer& layer, const std::vector<T>& all) {
  std::vector<T> part;
  if (all.empty()) return part;
  for (const std::size_t c : layer.contours) part.push_back(all[c]);
  return part;
}

/// Red, green and blue, 0 to 255: of what has no colour of its own, black.
[[nodiscard]] std::array<double, 3> rgb_of(const Paint& paint);

/// "#rrggbb", "currentColor" or "none"; of what nothing was said about "black".
[[nodiscard]] std::string color_text(const Paint& paint);

}  // namespace v0
}  // namespace tandem
