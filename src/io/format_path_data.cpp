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

void append_path(std::string& text, std::span<const double> points, bool closed,
                 const std::vector<bool>& lines, int precision) {
  const auto point = [&](std::size_t i) { return points.subspan(2 * i, 2); };
  text += 'M';
  append_point(text, point(0), precision);
  for (std::size_t k = 0; 6 * k + 2 < points.size(); ++k) {
    if (k < lines.size() && lines[k]) {
      text += 'L';
    } else {
      text += 'C';
      append_point(text, point(3 * k + 1), precision);
      text += ' ';
      append_point(text, point(3 * k + 2), precision);
      text += ' ';
    }
    append_point(text, point(3 * k + 3), precision);
  }
  if (closed) text += 'Z';
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
    append_path(text, paths[i].control_points().data(), paths[i].is_closed(),
                i < lines.size() ? lines[i] : no_lines, precision);
  }
  return text;
}

std::string format_path_data(const PathMorph& morph, double s, int precision) {
  return std::string(PathDataWriter(morph, precision)(s));
}

PathDataWriter::PathDataWriter(const PathMorph& morph, int precision)
    : morph_(&morph), precision_(precision), points_(morph.coordinate_count()) {}

std::string_view PathDataWriter::operator()(double s) {
  morph_->at(s, points_);
  text_.clear();
  std::span<const double> points = points_;
  for (const PathContour& contour : morph_->contours()) {
    const std::size_t size = 6 * contour.lines.size() + 2;
    append_path(text_, points.first(size), contour.keys.front().is_closed(), contour.lines, precision_);
    points = points.subspan(size);
  }
  return text_;
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
