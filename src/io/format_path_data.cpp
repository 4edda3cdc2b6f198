#include <fmt/format.h>

#include <limits>

#include "io/number.h"
#include "io/svg_parts.h"
#include "tandem/error.h"
#include "tandem/io/path_data.h"
#include "tandem/morph/key_frames.h"

namespace tandem {
inline namespace v0 {
namespace {

void append_point(std::string& text, std::span<const double> p, int precision) {
  append_number(text, p[0], precision);
  text += ' ';
  append_number(text, p[1], precision);
}

void append_path(std::string& text, const CubicPath& path, const std::vector<bool>& lines, int precision) {
  const Points& points = path.control_points();
  text += 'M';
  append_point(text, points[0], precision);
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    if (k < lines.size() && lines[k]) {
      text += 'L';
    } else {
      text += 'C';
      append_point(text, points[3 * k + 1], precision);
      text += ' ';
      append_point(text, points[3 * k + 2], precision);
      text += ' ';
    }
    append_point(text, points[3 * k + 3], precision);
  }
  if (path.is_closed()) text += 'Z';
}

}  // namespace

std::string format_path_data(std::span<const CubicPath> paths, std::span<const std::vector<bool>> lines,
                             int precision) {
  static const std::vector<bool> no_lines;
  std::string text;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (paths[i].dim() != 2) {
      throw InvalidArgument(
          fmt::format("path data: path {} has dimension {}, expected 2", i, paths[i].dim()));
    }
    append_path(text, paths[i], i < lines.size() ? lines[i] : no_lines, precision);
  }
  return text;
}

std::string format_path_data(const PathMorph& morph, double s, int precision) {
  std::vector<std::vector<bool>> lines;
  lines.reserve(morph.contours().size());
  for (const PathContour& contour : morph.contours()) lines.push_back(contour.lines);
  return format_path_data(morph.at(s), lines, precision);
}

std::vector<std::string> format_key_paths(const PathMorph& morph, int precision) {
  // The keys are frames whatever the tolerance; no others are asked for.
  const KeyFrames frames = key_frames(morph, {.tolerance = std::numeric_limits<double>::max()});
  const int decimals = decimals_for(view_of(frames.box), precision);
  std::vector<std::string> keys;
  for (const std::size_t key : frames.keys) {
    keys.push_back(format_path_data(frames.paths[key], frames.lines, decimals));
  }
  return keys;
}

}  // namespace v0
}  // namespace tandem
