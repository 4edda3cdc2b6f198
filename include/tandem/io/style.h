#pragma once

#include <array>

namespace tandem {
inline namespace v0 {

/// What an area or a line is painted with.
struct Paint {
  enum class Kind {
    none,
    color,
    current,   ///< CSS's currentColor: black where there is no page around it
    automatic  ///< nothing was said: black, or whatever the page says
  };
  Kind kind = Kind::none;
  std::array<double, 3> rgb{};  ///< of a color: red, green, blue (sRGB), 0 to 255
  double opacity = 1.0;         ///< 0 to 1

  [[nodiscard]] bool paints() const noexcept { return kind != Kind::none; }
  friend bool operator==(const Paint&, const Paint&) = default;
};

enum class LineCap { butt, round, square };
enum class LineJoin { miter, round, bevel };

/// How a shape is drawn: SVG's presentation, with its initial values. Everything that lengths are measured in
/// is the shape's own unit. `opacity` of an element, which SVG applies to area and line together, counts for
/// each of them.
struct Style {
  Paint fill{Paint::Kind::automatic, {}, 1.0};
  Paint stroke;
  double stroke_width = 1.0;
  LineCap line_cap = LineCap::butt;
  LineJoin line_join = LineJoin::miter;
  double miter_limit = 4.0;
  friend bool operator==(const Style&, const Style&) = default;
};

/// The part of the plane that a picture shows.
struct ViewBox {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
  friend bool operator==(const ViewBox&, const ViewBox&) = default;
};

}  // namespace v0
}  // namespace tandem
