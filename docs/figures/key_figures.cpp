#include "key_figures.h"

#include <fmt/format.h>

#include <vector>

#include "sheet.h"
#include "tandem/io/csv.h"
#include "tandem/io/files.h"
#include "tandem/io/load.h"
#include "tandem/io/motion_picture.h"
#include "tandem/io/path_data.h"
#include "tandem/tandem.h"

namespace tandem::figures {
namespace {

/// Keys filled, in-betweens as thin outlines, and the ways of the joints.
std::string ways(const PathMorph& morph) {
  constexpr int kParts = 96;
  std::string text;
  std::vector<std::string> joints;
  for (int i = 0; i <= kParts; ++i) {
    const double s = static_cast<double>(i) / kParts;
    const std::vector<CubicPath> paths = morph.at(s);
    std::size_t joint = 0;
    for (const CubicPath& path : paths) {
      for (std::size_t k = 0; k < path.segment_count(); ++k, ++joint) {
        if (i == 0) joints.emplace_back();
        const auto p = path.control_points()[3 * k];
        joints[joint] += fmt::format("{}{:.2f} {:.2f}", i == 0 ? "M" : "L", p[0], p[1]);
      }
    }
    if (i % 8 == 0) {
      text += fmt::format("<path fill=\"none\" stroke=\"#8a93a5\" stroke-width=\"0.2\" d=\"{}\"/>\n",
                          format_path_data(morph, s, 2));
    }
  }
  for (const double s : morph.key_times()) {
    text += fmt::format("<path fill=\"#1f2733\" fill-opacity=\"0.85\" d=\"{}\"/>\n",
                        format_path_data(morph, s, 2));
  }
  for (const std::string& joint : joints) {
    text += fmt::format("<path fill=\"none\" stroke=\"#c2562f\" stroke-width=\"0.35\" d=\"{}\"/>\n", joint);
  }
  return text;
}

/// Three keys on a bent way, from key to key and smoothly.
std::string smooth_keys() {
  const std::vector<Shape> keys = {
      load_shape("M0 30H10V40H0Z"), load_shape("M35 2H49L42 16Z"),
      load_shape("M80 20C86 20 90 24 90 30C90 36 86 40 80 40C74 40 70 36 70 30C70 24 74 20 80 20Z"),
      load_shape("M108 4H122V18H108Z")};
  MorphOptions options;
  options.match.rotate = false;
  options.times = {0.0, 0.3, 0.7, 1.0};
  Sheet sheet(400, 150);
  for (const bool smooth : {false, true}) {
    options.smooth = smooth;
    sheet.add_svg(smooth ? "Smooth" : "From key to key",
                  "<g transform=\"translate(6 6) scale(3)\">" + ways(PathMorph(keys, options)) + "</g>", 400,
                  150);
  }
  return sheet.svg();
}

std::string motions() {
  const std::string walk = "examples/data/walk.csv";
  const std::string run = "examples/data/run.csv";
  const CsvTable a = parse_csv_table(read_file(walk), walk);
  const CsvTable b = parse_csv_table(read_file(run), run);
  const MotionMorph morph(std::vector<Curve>{a.curve, b.curve});
  return format_motion_svg(morph, {.columns = a.columns, .title = "A walk becomes a run", .in_betweens = {}});
}

}  // namespace

std::map<std::string, std::string> key_figures() {
  return {{"smooth-keys.svg", smooth_keys()}, {"motions.svg", motions()}};
}

}  // namespace tandem::figures
