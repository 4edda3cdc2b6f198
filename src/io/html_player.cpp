#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "io/html.h"
#include "io/html_player_page.h"
#include "io/layers.h"
#include "io/number.h"
#include "io/page.h"
#include "io/style_properties.h"
#include "io/timeline.h"
#include "tandem/io/svg.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr int kAngleDecimals = 6;

// M's point, then one point for every L and three for every C: as the page's script reads them.
std::string numbers(const CubicPath& path, const std::vector<bool>& lines, int precision) {
  std::string text = "[";
  const auto append = [&](std::size_t i) {
    for (double x : path.control_points()[i]) {
      if (text.size() > 1) text += ',';
      append_number(text, x, precision);
    }
  };
  append(0);
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    for (std::size_t i = lines[k] ? 3 : 1; i <= 3; ++i) append(3 * k + i);
  }
  return text + "]";
}

std::string contour_data(const KeyFrames& frames, std::size_t contour, int precision) {
  std::string commands;
  for (const bool line : frames.lines[contour]) commands += line ? 'L' : 'C';
  std::string text = fmt::format("{{\"closed\":{},\"commands\":\"{}\",\"frames\":[",
                                 frames.paths.front()[contour].is_closed(), commands);
  for (std::size_t frame = 0; frame < frames.paths.size(); ++frame) {
    if (frame > 0) text += ",\n";
    text += numbers(frames.paths[frame][contour], frames.lines[contour], precision);
  }
  return text + "]}";
}

// [x, y, degrees] of the moving frame at every frame of the film.
std::string pose_data(const KeyFrames& frames, int precision) {
  std::string text = "[";
  for (const FramePose& pose : frames.poses) {
    if (text.size() > 1) text += ',';
    text += fmt::format("[{},{},{}]", format_number(pose.center.x, precision),
                        format_number(pose.center.y, precision), format_number(pose.degrees, kAngleDecimals));
  }
  return text + "]";
}

/// "currentColor" is the page's ink, and so is what nothing was said about.
std::string page_color(const Paint& paint) {
  return paint.kind == Paint::Kind::automatic ? "currentColor" : color_text(paint);
}

// Per key [fill, its opacity, stroke, its opacity, width of lines].
std::string layer_data(const Layer& layer, int precision) {
  std::string text = fmt::format("{{\"contours\":[{}],\"keys\":[", fmt::join(layer.contours, ","));
  for (const Style& key : layer.keys) {
    text += fmt::format("{}[\"{}\",{},\"{}\",{},{}]", &key == &layer.keys.front() ? "" : ",",
                        page_color(key.fill), format_number(key.fill.opacity), page_color(key.stroke),
                        format_number(key.stroke.opacity), format_number(key.stroke_width, precision));
  }
  text += "],\"fixed\":{";
  bool first = true;
  for (const StyleProperty& property : style_properties({layer.keys.front()}, FillRule::nonzero, precision)) {
    constexpr std::string_view kFixed = "stroke-linecap stroke-linejoin stroke-miterlimit";
    if (kFixed.find(property.name) == std::string_view::npos || property.name == "stroke") continue;
    text += fmt::format("{}\"{}\":\"{}\"", first ? "" : ",", property.name, property.values.front());
    first = false;
  }
  return text + "}}";
}

std::string layers_data(const PathMorph& morph, const Look& look, const View& view) {
  std::string text;
  for (const Layer& layer : layers_of(morph, look, view, {Paint::Kind::current, {}, 1.0})) {
    text += (text.empty() ? "" : ",\n") + layer_data(layer, decimals_for(view.size()));
  }
  return text;
}

std::string morph_data(const PathMorph& morph, const AnimationOptions& options, const Look& look) {
  const KeyFrames frames = key_frames(morph, {.tolerance = options.tolerance, .bake_turn = false});
  const View view = view_of(look, frames.box);
  const int precision = decimals_for(view, options.precision);
  const std::vector<Easing> easings = parse_easings(options.easing, frames.keys.size() - 1);
  std::string text = "{\"times\":[";
  for (const double s : frames.times) text += (s == 0.0 ? "" : ",") + format_number(s);
  text += fmt::format(
      "],\"keys\":[{}],\"stretches\":[{}],\"view\":[{},{},{},{}],\"rule\":\"{}\",\"duration\":{},"
      "\"alternate\":{},\"repeat\":{},"
      "\"easings\":[{}],\n\"contours\":[",
      fmt::join(frames.keys, ","), fmt::join(eased_stretches(frames, easings), ","),
      format_number(view.x, precision), format_number(view.y, precision),
      format_number(view.width, precision), format_number(view.height, precision),
      frames.fill_rule == FillRule::evenodd ? "evenodd" : "nonzero", format_number(options.duration),
      options.alternate, options.repeat, format_easings(easings));
  for (std::size_t c = 0; c < frames.paths.front().size(); ++c) {
    if (c > 0) text += ",\n";
    text += contour_data(frames, c, precision);
  }
  text +=
      fmt::format("],\n\"layers\":[{}],\"plain\":{}", layers_data(morph, look, view), look.styles.empty());
  if (!frames.poses.empty()) text += ",\n\"poses\":" + pose_data(frames, precision);
  return text + '}';
}

}  // namespace

std::string format_html_player(const PathMorph& morph, const std::string& title,
                               const AnimationOptions& options, const Look& look) {
  check_animation(options);
  return format_page(
      {title, kPlayerStyle,
       replace_all(kPlayerBody, "%BAR%", play_bar("Position s between the shapes", kPlayerMore)),
       morph_data(morph, options, look), play_script() + kPlayerScript});
}

}  // namespace v0
}  // namespace tandem
