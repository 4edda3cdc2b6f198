#pragma once

#include <string>

#include "tandem/curve/curve.h"
#include "tandem/match/match.h"

namespace tandem {
inline namespace v0 {

/// A rectangle of the page, in pixels.
struct Frame {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
};

/// Both curves with links between points that belong together, coloured along the path.
[[nodiscard]] std::string draw_links(const Curve& a, const Curve& b, const Correspondence& correspondence,
                                     Frame frame);

/// The cost table (rows: samples of a, downwards; columns: samples of b) with the path and v(u) over it. On
/// closed curves the part that the path runs over, unrolled.
[[nodiscard]] std::string draw_table(const Match& match, const MatchOptions& options, Frame frame);

/// "#rrggbb" from shares of red, green and blue in [0,1].
[[nodiscard]] std::string color(double red, double green, double blue);

/// Two decimals are enough for pixels.
[[nodiscard]] std::string pixels(double x);

}  // namespace v0
}  // namespace tandem
