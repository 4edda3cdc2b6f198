#include <fmt/format.h>

#include <cmath>

#include "io/easing.h"
#include "io/number.h"
#include "io/svg_parts.h"
#include "tandem/error.h"
#include "tandem/io/svg.h"

namespace tandem {
inline namespace v0 {
namespace {

// Of degrees: 1e-6 of them move nothing on a screen.
constexpr int kAngleDecimals = 6;

// The keys in the order in which the loop runs through them.
std::vector<std::size_t> loop_of(std::size_t key_count, bool alternate) {
  std::vector<std::size_t> order;
  for (std::size_t key = 0; key < key_count; ++key) order.push_back(key);
  if (alternate) {
    for (std::size_t key = key_count - 1; key-- > 0;) order.push_back(key);
  }
  return order;
}

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
std::string timing(std::size_t frames, std::size_t key_count, const AnimationOptions& options) {
  const double loop = options.duration * static_cast<double>(frames - 1) / static_cast<double>(key_count - 1);
  std::string text = fmt::format("dur=\"{}s\" repeatCount=\"indefinite\"", format_number(loop, 6));
  const std::string times = joined(frames, [&](std::size_t i) {
    return format_number(static_cast<double>(i) / static_cast<double>(frames - 1), 6);
  });
  text += fmt::format(" keyTimes=\"{}\"", times);
  const Easing easing = parse_easing(options.easing);
  if (easing.linear()) return text + " calcMode=\"linear\"";
  // On the way back the same motion runs backwards, so the curve is turned round.
  const std::string splines = joined(frames - 1, [&](std::size_t i) {
    const bool back = i + 1 >= key_count;
    return back ? fmt::format("{} {} {} {}", format_number(1.0 - easing.x2), format_number(1.0 - easing.y2),
                              format_number(1.0 - easing.x1), format_number(1.0 - easing.y1))
                : fmt::format("{} {} {} {}", format_number(easing.x1), format_number(easing.y1),
                              format_number(easing.x2), format_number(easing.y2));
  });
  return text + fmt::format(" calcMode=\"spline\" keySplines=\"{}\"", splines);
}

}  // namespace

std::string format_animated_svg(const PathMorph& morph, const AnimationOptions& options) {
  if (!(options.duration > 0.0 && std::isfinite(options.duration))) {
    throw InvalidArgument(fmt::format("animation: duration is {} s, expected > 0", options.duration));
  }
  const View view = view_of(morph.box());
  const int precision = decimals_for(view.size());
  std::vector<PathDataParts> keys;
  for (std::size_t key = 0; key < morph.key_count(); ++key) {
    std::vector<CubicPath> paths;
    for (const PathContour& contour : morph.contours()) paths.push_back(contour.keys[key]);
    keys.push_back(path_data_parts(paths, morph.contours(), precision));
  }
  const std::vector<std::size_t> order = loop_of(morph.key_count(), options.alternate);
  const std::string when = timing(order.size(), morph.key_count(), options);

  std::string text =
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{}\">\n", format_view_box(view));
  const auto animate_frame = [&](const char* type, const auto& value) {
    const std::string values =
        joined(order.size(), [&](std::size_t i) { return value(morph.poses()[order[i]]); });
    text += fmt::format(
        "<g transform=\"{0}({1})\">\n<animateTransform attributeName=\"transform\" type=\"{0}\" {2} "
        "values=\"{3}\"/>\n",
        type, value(morph.poses().front()), when, values);
  };
  // Turned evenly about a centre that moves evenly: what a browser does by itself, to the dot.
  if (morph.turns()) {
    animate_frame("translate", [&](const FramePose& pose) {
      return format_number(pose.center.x, precision) + " " + format_number(pose.center.y, precision);
    });
    animate_frame("rotate",
                  [](const FramePose& pose) { return format_number(pose.degrees, kAngleDecimals); });
  }
  const auto animate = [&](const std::string& attributes, std::string PathDataParts::*part) {
    if ((keys.front().*part).empty()) return;
    const std::string values = joined(order.size(), [&](std::size_t i) { return keys[order[i]].*part; });
    text += fmt::format("<path {} d=\"{}\">\n<animate attributeName=\"d\" {} values=\"{}\"/>\n</path>\n",
                        attributes, keys.front().*part, when, values);
  };
  animate(fill_attributes(morph.fill_rule()), &PathDataParts::filled);
  animate(stroke_attributes(view), &PathDataParts::stroked);
  return text + (morph.turns() ? "</g></g>\n</svg>\n" : "</svg>\n");
}

}  // namespace v0
}  // namespace tandem
