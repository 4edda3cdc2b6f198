#pragma once

#include <string>

namespace tandem {
inline namespace v0 {

/// How a morph is played; the same for all formats that move.
struct AnimationOptions {
  double duration = 2.0;  ///< seconds from the first key to the last
  /// From each key to the next: "linear", "ease", "ease-in", "ease-out", "ease-in-out" or "x1 y1 x2 y2", all
  /// in [0,1]. One for all steps, or one for each, separated by semicolons. A single one of a smooth morph
  /// (MorphOptions::smooth) times the whole way at once: nothing rests on the keys between.
  std::string easing = "linear";
  bool alternate = true;  ///< run back again
  bool repeat = true;     ///< for ever; otherwise once, and then rest at the end
  /// Decimals of coordinates; < 0: as many as keep rounding below 1e-5 of the picture's larger side.
  int precision = -1;
  /// How far in-betweens may be off where the blend is not linear in s, as a share of the diagonal
  /// (KeyFrames).
  double tolerance = 1e-3;
};

}  // namespace v0
}  // namespace tandem
