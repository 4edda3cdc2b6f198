#pragma once

#include <array>
#include <cstdlib>
#include <vector>

#include "tandem/shape/cubic_path.h"
#include "tandem/shape/path_builder.h"

/// Forty icons of Material Design Icons (npm package `@mdi/svg` 7.4.47; by Google, Austin Andrews, Michael
/// Irigoyen, Michael Richins and Simran, of the Pictogrammers), under the Apache License 2.0 (the `LICENSE`
/// of this repository). Their outlines are unchanged but for how they are written: absolute M, L, C and Z.
namespace tandem::test {

struct Icon {
  const char* name;
  const char* path_data;
};

/// None is nearly its own copy after a turn. The first twenty are of one contour, the others of several.
inline constexpr std::array<Icon, 40> kIcons{{
    {"language-kotlin", "M2 2L22 2L12 12L22 22L2 22Z"},
    {"diamond", "M6 2L2 8L12 22L22 8L18 2L6 2Z"},
    {"volume-low", "M7 9L7 15L11 15L16 20L16 4L11 9L7 9Z"},
    {"tie", "M6 2L10 6L7 17L12 22L17 17L14 6L18 2Z"},
    {"navigation-variant", "M21 3L3 10.53L3 11.5L9.84 14.16L12.5 21L13.46 21L21 3Z"},
    {"invoice", "M21 22L18 20L15 22L12 20L9 22L6 20L3 22L3 3L21 3L21 22Z"},
    {"numeric-4", "M9 7L9 13L13 13L13 17L15 17L15 7L13 7L13 11L11 11L11 7L9 7Z"},
    {"chart-areaspline-variant", "M22 21L2 21L2 3L4 3L4 15.54L9.5 6L16 9.78L20.24 2.45L21.97 3.45L22 21Z"},
    {"bulma", "M11.38 2L6.38 7L5.13 15.75L11.38 22L18.88 17L13.88 12L17.63 8.25L11.38 2Z"},
    {"pine-tree", "M10 21L10 18L3 18L8 13L5 13L10 8L7 8L12 3L17 8L14 8L19 13L16 13L21 18L14 18L14 21L10 21Z"},
    {"relation-one-to-many",
     "M22 13L22 19L21 19L19 17L11 17L11 9L7 9L7 11L5 11L5 9L2 9L2 7L5 7L5 5L7 5L7 7L13 7L13 15L19 15"
     "L21 13Z"},
    {"size-m",
     "M9 7C7.9 7 7 7.9 7 9L7 17L9 17L9 9L11 9L11 16L13 16L13 9L15 9L15 17L17 17L17 9"
     "C17 7.9 16.11 7 15 7L9 7Z"},
    {"heart-half",
     "M13 7.2L13 17.74L13 20.44L12 21.35L10.55 20.03C5.4 15.36 2 12.27 2 8.5C2 5.41 4.42 3 7.5 3"
     "C10 3 13 5 13 7.2Z"},
    {"power-plug",
     "M16 7L16 3L14 3L14 7L10 7L10 3L8 3L8 7L8 7C7 7 6 8 6 9L6 14.5L9.5 18L9.5 21L14.5 21L14.5 18"
     "L18 14.5L18 9C18 8 17 7 16 7Z"},
    {"label-variant",
     "M3.5 19L8.34 12L3.5 5L14.5 5C15.17 5 15.72 5.3 16.13 5.86L20.5 12L16.13 18.14"
     "C15.72 18.7 15.17 19 14.5 19L3.5 19Z"},
    {"tooltip",
     "M4 2L20 2C21.1046 2 22 2.8954 22 4L22 16C22 17.1046 21.1046 18 20 18L16 18L12 22L8 18L4 18"
     "C2.8954 18 2 17.1046 2 16L2 4C2 2.8954 2.8954 2 4 2Z"},
    {"horse-variant",
     "M20 8L20 16L17 17L13.91 11.5C13.65 11.04 12.92 11.27 13 11.81L14 21L4 17L5.15 8.94"
     "C5.64 5.53 8.56 3 12 3L20 3L18.42 5.37C19.36 5.88 20 6.86 20 8Z"},
    {"undo",
     "M12.5 8C9.85 8 7.45 9 5.6 10.6L2 7L2 16L11 16L7.38 12.38C8.77 11.22 10.54 10.5 12.5 10.5"
     "C16.04 10.5 19.05 12.81 20.1 16L22.47 15.22C21.08 11.03 17.15 8 12.5 8Z"},
    {"sickle",
     "M19.3 7.2C17.5 4.7 14.9 3 12 2C26.2 10.5 15.4 22.9 8.5 15.5L5.9 16L2.5 19.4"
     "C1.9 20 1.9 21 2.5 21.5C3.1 22.1 4.1 22.1 4.6 21.5L7.8 18.3C15.3 24.3 25 15 19.3 7.2Z"},
    {"food-apple",
     "M20 10C22 13 17 22 15 22C13 22 13 21 12 21C11 21 11 22 9 22C7 22 2 13 4 10C6 7 9 7 11 8L11 5"
     "C5.38 8.07 4.11 3.78 4.11 3.78C4.11 3.78 6.77 0.19 11 5L11 3L13 3L13 8C15 7 18 7 20 10Z"},
    {"spear", "M16 9L16.41 9L3.41 22L2 20.59L15 7.59L15 9L16 9ZM16 4L16 8L20 8L22 2L16 4Z"},
    {"step-backward-2", "M17 5L14 5L14 19L17 19L17 5ZM12 5L1 12L12 19L12 5ZM22 5L19 5L19 19L22 19L22 5Z"},
    {"home-floor-1", "M12 3L2 12L5 12L5 20L19 20L19 12L22 12L12 3ZM10 8L14 8L14 18L12 18L12 10L10 10L10 8Z"},
    {"distribute-horizontal-right",
     "M3 17L3 7L8 7L8 2L10 2L10 22L8 22L8 17L3 17ZM19 22L21 22L21 2L19 2L19 5L14 5L14 19L19 19L19 22Z"},
    {"not-equal",
     "M21 10L9 10L9 8L21 8L21 10ZM21 16L9 16L9 14L21 14L21 16ZM4 5L6 5L6 16L4 16L4 5ZM6 18L6 20L4 20"
     "L4 18L6 18Z"},
    {"download-outline",
     "M13 5L13 11L14.17 11L12 13.17L9.83 11L11 11L11 5L13 5ZM15 3L9 3L9 9L5 9L12 16L19 9L15 9L15 3Z"
     "M19 18L5 18L5 20L19 20L19 18Z"},
    {"wall-sconce-outline",
     "M13.7 6L15.92 11L10.08 11L12.3 6L13.7 6ZM15 4L11 4L7 13L19 13L15 4ZM4 14L4 22L6 22L6 19L14 19"
     "L14 14L12 14L12 17L6 17L6 14L4 14Z"},
    {"arrow-down-drop-circle",
     "M12 2C17.5228 2 22 6.4772 22 12C22 17.5228 17.5228 22 12 22C6.4772 22 2 17.5228 2 12"
     "C2 6.4772 6.4772 2 12 2ZM7 10L12 15L17 10L7 10Z"},
    {"pot-mix",
     "M14.6 9L18 3.1L19.7 4.1L16.9 9L14.6 9ZM14 10L3 10L3 12L5 12L5 19C5 20.1 5.9 21 7 21L17 21"
     "C18.1 21 19 20.1 19 19L19 12L21 12L21 10L14 10Z"},
    {"clock-time-two",
     "M12 2C6.5 2 2 6.5 2 12C2 17.5 6.5 22 12 22C17.5 22 22 17.5 22 12C22 6.5 17.5 2 12 2ZM12.5 13"
     "L11 13L11 7L12.5 7L12.5 11.3L16.2 9.2L17 10.5L12.5 13Z"},
    {"home-off",
     "M20.84 22.73L18.11 20L14 20L14 15.89L12.11 14L10 14L10 20L5 20L5 12L2 12L6.27 8.16L1.11 3"
     "L2.39 1.73L22.11 21.46L20.84 22.73ZM19 12L22 12L12 3L8.95 5.75L19 15.8L19 12Z"},
    {"file-video",
     "M13 9L18.5 9L13 3.5L13 9ZM6 2L14 2L20 8L20 20C20 21.1046 19.1046 22 18 22L6 22"
     "C4.89 22 4 21.1 4 20L4 4C4 2.89 4.89 2 6 2ZM17 19L17 13L14 15.2L14 13L7 13L7 19L14 19L14 16.8"
     "L17 19Z"},
    {"folder-off",
     "M22.11 21.46L20.84 22.73L18.11 20L4 20C2.9 20 2 19.11 2 18L2 6C2 5.42 2.25 4.9 2.64 4.53L1.11 3"
     "L2.39 1.73L22.11 21.46ZM22 18L22 8C22 6.89 21.1 6 20 6L12 6L10 4L7.2 4L21.88 18.68"
     "C21.96 18.47 22 18.24 22 18Z"},
    {"undo-variant",
     "M13.5 7C17.0899 7 20 9.9101 20 13.5C20 17.0899 17.0899 20 13.5 20L10 20L10 18L13.5 18"
     "C16 18 18 16 18 13.5C18 11 16 9 13.5 9L7.83 9L10.91 12.09L9.5 13.5L4 8L9.5 2.5L10.92 3.91L7.83 7"
     "L13.5 7ZM6 18L8 18L8 20L6 20L6 18Z"},
    {"calendar-weekend",
     "M19 19L19 8L5 8L5 19L19 19ZM16 1L18 1L18 3L19 3C20.11 3 21 3.9 21 5L21 19"
     "C21 20.11 20.11 21 19 21L5 21C3.9 21 3 20.11 3 19L3 5C3 3.9 3.9 3 5 3L6 3L6 1L8 1L8 3L16 3L16 1Z"
     "M7 17L7 10L9 10L9 17L7 17ZM15 10L17 10L17 17L15 17L15 10Z"},
    {"mailbox-up",
     "M5 9L9 9L9 11L5 11L5 9ZM22 9L22 18C22 19.1046 21.1046 20 20 20L2 20L2 9C2 6.2386 4.2386 4 7 4"
     "L17 4C19.7614 4 22 6.2386 22 9ZM10 9C10 7.3431 8.6569 6 7 6C5.3431 6 4 7.3431 4 9L4 18L10 18"
     "L10 9ZM16 7L12 7L12 13L14 13L14 9L16 9L16 7Z"},
    {"printer-pos-pause",
     "M17 9L7 9L7 4L17 4L17 9ZM20 13.09C19.67 13.04 19.34 13 19 13C15.69 13 13 15.69 13 19L4 19L4 12"
     "C4 10.9 4.89 10 6 10L18 10C19.11 10 20 10.9 20 12L20 13.09ZM10 12L6 12L6 14L10 14L10 12ZM16 22"
     "L18 22L18 16L16 16L16 22ZM20 16L20 22L22 22L22 16L20 16Z"},
    {"stool-outline",
     "M20 6C20 3.79 18.21 2 16 2L8 2C5.78 2 4 3.79 4 6L4 8L7 8L4 22L6 22L7.5 15L11 15L11 22L13 22"
     "L13 15L16.5 15L18 22L20 22L17 8L20 8L20 6ZM7.93 13L9 8L11 8L11 13L7.93 13ZM16.07 13L13 13L13 8"
     "L15 8L16.07 13ZM6 6C6 4.9 6.89 4 8 4L16 4C17.1 4 18 4.9 18 6L6 6Z"},
    {"book-education-outline",
     "M6 20L13 20L13 22L6 22C4.89 22 4 21.11 4 20L4 4C4 2.9 4.89 2 6 2L18 2C19.11 2 20 2.9 20 4"
     "L20 12.54L18.5 11.72L18 12L18 4L13 4L13 12L10.5 9.75L8 12L8 4L6 4L6 20ZM24 17L18.5 14L13 17"
     "L18.5 20L24 17ZM15 19.09L15 21.09L18.5 23L22 21.09L22 19.09L18.5 21L15 19.09Z"},
    {"umbrella-outline",
     "M12 4C8.9 4 6.18 6.03 5.3 9L18.7 9C17.82 6.04 15.09 4 12 4ZM12 2C16.9706 2 21 6.0294 21 11L13 11"
     "L13 19C13 20.6569 11.6569 22 10 22C8.3431 22 7 20.6569 7 19L7 18L9 18L9 19"
     "C9 19.5523 9.4477 20 10 20C10.5523 20 11 19.5523 11 19L11 11L3 11C3 6.0294 7.0294 2 12 2Z"},
}};

/// The contours of an icon.
inline std::vector<CubicPath> paths_of(const Icon& icon) {
  PathBuilder builder;
  const char* text = icon.path_data;
  const auto point = [&text] {
    char* rest = nullptr;
    const double x = std::strtod(text, &rest);
    const double y = std::strtod(rest, &rest);
    text = rest;
    return Vec2{x, y};
  };
  while (*text != '\0') {
    const char command = *text++;
    if (command == 'M') {
      builder.move_to(point());
    } else if (command == 'L') {
      builder.line_to(point());
    } else if (command == 'C') {
      const Vec2 first = point();
      const Vec2 second = point();
      builder.cubic_to(first, second, point());
    } else {
      builder.close();
    }
  }
  return builder.take();
}

}  // namespace tandem::test
