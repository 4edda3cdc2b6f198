#include <fmt/format.h>

#include <algorithm>

#include "io/number.h"
#include "io/svg_parts.h"
#include "io/timeline.h"
#include "tandem/io/svg.h"

namespace tandem {
inline namespace v0 {
namespace {

// Of degrees, shares of time and easings: 1e-6 of them move nothing on a screen.
constexpr int kDecimals = 6;

// Style sheets cannot stop an animation of this kind, but they can show a still picture instead.
constexpr const char* kReducedMotion =
    "<style>@media (prefers-reduced-motion: reduce) { .tandem-moving { display: none } .tandem-still { "
    "display: inline } "
    "}</style>\n";

template <class Format>
std::string joined(std::size_t count, Format format) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += ';';
    text += format(i);
  }
  return text;
}

// Attributes of the animation but its values: when, how often, how fast.
std::string timing(const std::vector<TimelineStep>& steps, const AnimationOptions& options) {
  std::string text =
      fmt::format("dur=\"{}s\" {}", format_number(loop_seconds(options), kDecimals),
                  options.repeat ? "repeatCount=\"indefinite\"" : "repeatCount=\"1\" fill=\"freeze\"");
  text += fmt::format(" keyTimes=\"{}\"", joined(steps.size(), [&](std::size_t i) {
                        return format_number(steps[i].time, kDecimals);
                      }));
  const bool linear =
      std::all_of(steps.begin(), steps.end(), [](const TimelineStep& step) { return step.easing.linear(); });
  if (linear) return text + " calcMode=\"linear\"";
  const std::string splines = joined(steps.size() - 1, [&](std::size_t i) {
    const Easing& easing = steps[i].easing;
    return fmt::format("{} {} {} {}", format_number(easing.x1, kDecimals),
                       format_number(easing.y1, kDecimals), format_number(easing.x2, kDecimals),
                       format_number(easing.y2, kDecimals));
  });
  return text + fmt::format(" calcMode=\"spline\" keySplines=\"{}\"", splines);
}

// The picture of a frame at rest.
std::string still(const KeyFrames& frames, std::size_t frame, const PathDataParts& parts, const View& view,
                  int precision) {
  std::string text = "<g class=\"tandem-still\" display=\"none\"";
  if (!frames.poses.empty()) {
    const FramePose& pose = frames.poses[frame];
    text += fmt::format(" transform=\"translate({} {}) rotate({})\"", format_number(pose.center.x, precision),
                        format_number(pose.center.y, precision), format_number(pose.degrees, kDecimals));
  }
  text += ">\n";
  if (!parts.filled.empty())
    text += fmt::format("<path {} d=\"{}\"/>\n", fill_attributes(frames.fill_rule), parts.filled);
  if (!parts.stroked.empty())
    text += fmt::format("<path {} d=\"{}\"/>\n", stroke_attributes(view), parts.stroked);
  return text + "</g>\n";
}

}  // namespace

std::string format_animated_svg(const PathMorph& morph, const AnimationOptions& options) {
  check_animation(options);
  // A browser turns and moves groups evenly by itself, to the dot.
  const KeyFrames frames = key_frames(morph, {.tolerance = options.tolerance, .bake_turn = false});
  const View view = view_of(frames.box);
  const int precision = decimals_for(view, options.precision);
  std::vector<PathDataParts> parts;
  for (const std::vector<CubicPath>& paths : frames.paths) {
    parts.push_back(path_data_parts(paths, frames.lines, precision));
  }
  const std::vector<TimelineStep> steps = loop_timeline(frames, options);
  const std::string when = timing(steps, options);

  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{}\">\n{}<g class=\"tandem-moving\">\n",
      format_view_box(view), kReducedMotion);
  const auto animate_frame = [&](const char* type, const auto& value) {
    const std::string values =
        joined(steps.size(), [&](std::size_t i) { return value(frames.poses[steps[i].frame]); });
    text += fmt::format(
        "<g transform=\"{0}({1})\">\n<animateTransform attributeName=\"transform\" type=\"{0}\" {2} "
        "values=\"{3}\"/>\n",
        type, value(frames.poses.front()), when, values);
  };
  if (!frames.poses.empty()) {
    animate_frame("translate", [&](const FramePose& pose) {
      return format_number(pose.center.x, precision) + " " + format_number(pose.center.y, precision);
    });
    animate_frame("rotate", [](const FramePose& pose) { return format_number(pose.degrees, kDecimals); });
  }
  const auto animate = [&](const std::string& attributes, std::string PathDataParts::*part) {
    if ((parts.front().*part).empty()) return;
    const std::string values =
        joined(steps.size(), [&](std::size_t i) { return parts[steps[i].frame].*part; });
    text += fmt::format("<path {} d=\"{}\">\n<animate attributeName=\"d\" {} values=\"{}\"/>\n</path>\n",
                        attributes, parts.front().*part, when, values);
  };
  animate(fill_attributes(frames.fill_rule), &PathDataParts::filled);
  animate(stroke_attributes(view), &PathDataParts::stroked);
  if (!frames.poses.empty()) text += "</g></g>\n";
  return text + "</g>\n" + still(frames, frames.paths.size() - 1, parts.back(), view, precision) + "</svg>\n";
}

}  // namespace v0
}  // namespace tandem
