#pragma once

#include <string>
#include <vector>

#include "tandem/io/load.h"
#include "tandem/morph/path_morph.h"

namespace tandem::test {

/// Affine, so that the keys say it all.
inline PathMorph path_morph(const std::vector<Shape>& keys, MorphOptions options = {}) {
  options.blend = BlendKind::affine;
  return PathMorph(keys, options);
}

/// A morph of path data; few nodes, for tests in which it does not matter how good the match is.
inline PathMorph morph_of(const std::vector<std::string>& keys, FillRule fill_rule = FillRule::nonzero) {
  std::vector<Shape> shapes;
  for (const std::string& key : keys) shapes.push_back(load_shape(key, {.fill_rule = fill_rule}));
  MorphOptions options;
  options.match.samples = {24, 24};
  return path_morph(shapes, options);
}

inline PathMorph box_to_disc() {
  return morph_of({"M0 0H10V10H0Z", "M10 0C16 0 20 4 20 10C20 16 16 20 10 20C4 20 0 16 0 10C0 4 4 0 10 0Z"});
}

/// A closed and an open contour.
inline PathMorph mixed() {
  return morph_of({"M0 0H10V10H0ZM12 0L14 8", "M0 0H12V9H1ZM12 0L18 6"});
}

/// Turns by 90 degrees.
inline PathMorph turning() {
  return morph_of({"M0 0H9V2H3V5H0Z", "M0 0V9H-2V3H-5V0Z"});
}

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t at = 0;
  for (std::size_t next; (next = text.find(separator, at)) != std::string::npos; at = next + 1) {
    parts.push_back(text.substr(at, next - at));
  }
  parts.push_back(text.substr(at));
  return parts;
}

/// The letters of path data.
inline std::string commands(const std::string& d) {
  std::string letters;
  for (const char c : d) {
    if (c >= 'A' && c <= 'Z') letters += c;
  }
  return letters;
}

}  // namespace tandem::test
