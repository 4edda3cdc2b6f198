#include "tandem/io/css.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/canvas.h"
#include "io/layers.h"
#include "io/number.h"
#include "io/style_properties.h"
#include "io/timeline.h"
#include "tandem/error.h"
#include "tandem/io/path_data.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr int kDecimals = 6;  // of degrees and easings
constexpr int kPercentDecimals = 4;

std::string timing_function(const Easing& easing) {
  if (easing.linear()) return "linear";
  return fmt::format("cubic-bezier({}, {}, {}, {})", format_number(easing.x1, kDecimals),
                     format_number(easing.y1, kDecimals), format_number(easing.x2, kDecimals),
                     format_number(easing.y2, kDecimals));
}

/// What an animation does at its steps: "a: b; c: d;".
struct Track {
  std::string name;  ///< of the @keyframes
  std::vector<TimelineStep> steps;
  std::vector<std::string> values;  ///< per frame
};

/// One class: what it always is, and what it is at each frame.
struct Rule {
  std::string name;
  std::string constants;
  std::vector<Track> tracks;
};

std::string format_track(const Track& track) {
  std::string text = fmt::format("@keyframes {} {{\n", track.name);
  for (const TimelineStep& step : track.steps) {
    const std::string timing =
        step.easing.linear() ? ""
                             : fmt::format(" animation-timing-function: {};", timing_function(step.easing));
    text += fmt::format("  {}% {{ {}{} }}\n", format_number(100.0 * step.time, kPercentDecimals),
                        track.values[step.frame], timing);
  }
  return text + "}\n";
}

std::string format_rule(const Rule& rule, const AnimationOptions& options) {
  const std::string times = options.repeat ? "infinite" : options.alternate ? "2" : "1";
  std::string first, last, animation, key_frames;
  for (const Track& track : rule.tracks) {
    first += ' ' + track.values.front();
    last += ' ' + track.values.back();
    // The frames run one way: browsers turn them, and their timing functions, round by themselves.
    animation +=
        fmt::format("{}{} {}s linear {}{} both", animation.empty() ? "" : ", ", track.name,
                    format_number(options.duration, kDecimals), times, options.alternate ? " alternate" : "");
    key_frames += format_track(track);
  }
  return fmt::format(
      ".{0} {{ {1}{2} animation: {3}; }}\n{4}@media (prefers-reduced-motion: reduce) {{ .{0} {{ animation: "
      "none;{5} "
      "}} }}\n",
      rule.name, rule.constants, first, animation, key_frames, last);
}

/// Adds what does not change to the rule, and the rest as a track of its own.
void add_properties(Rule& rule, const std::vector<StyleProperty>& properties,
                    const std::vector<TimelineStep>& key_steps) {
  Track track{rule.name + "-style", key_steps, std::vector<std::string>(key_steps.size())};
  bool any = false;
  for (const StyleProperty& property : properties) {
    if (!property.changes()) {
      rule.constants +=
          fmt::format("{}{}: {};", rule.constants.empty() ? "" : " ", property.name, property.values.front());
      continue;
    }
    any = true;
    for (std::size_t key = 0; key < track.values.size(); ++key) {
      track.values[key] +=
          fmt::format("{}{}: {};", track.values[key].empty() ? "" : " ", property.name, property.values[key]);
    }
  }
  if (any) rule.tracks.push_back(std::move(track));
}

/// What is animated, and when.
struct Film {
  KeyFrames frames;
  View view;
  std::vector<Layer> layers;
  std::vector<TimelineStep> steps;
  std::vector<TimelineStep> key_steps;
  bool plain = true;  ///< without styles
};

/// NAME for what is filled, or for all that is drawn; NAME-stroke for the lines beside, or alone;
/// NAME-growing.
std::string class_of(const Film& film, const Layer& layer, const std::string& name) {
  if (layer.name == "stroked") return film.layers.front().fills() || film.plain ? name + "-stroke" : name;
  return layer.name == "filled" || layer.name == "drawn" ? name : name + '-' + layer.name;
}

std::string pose_text(const FramePose& pose, int precision) {
  return fmt::format(" transform: translate({}px, {}px) rotate({}deg);",
                     format_number(pose.center.x, precision), format_number(pose.center.y, precision),
                     format_number(pose.degrees, kDecimals));
}

std::string format_d(const Film& film, const AnimationOptions& animation, const std::string& name) {
  const int precision = decimals_for(film.view, animation.precision);
  std::string markup, rules;
  for (const Layer& layer : film.layers) {
    Rule rule{class_of(film, layer, name), {}, {}};
    Track path{rule.name, film.steps, {}};
    for (std::size_t i = 0; i < film.frames.paths.size(); ++i) {
      path.values.push_back(
          fmt::format("d: path(\"{}\");{}",
                      format_path_data(part_of(layer, film.frames.paths[i]),
                                       part_of(layer, film.frames.lines), precision),
                      film.frames.poses.empty() ? "" : pose_text(film.frames.poses[i], precision)));
    }
    rule.tracks.push_back(std::move(path));
    add_properties(rule, style_properties(layer.keys, film.frames.fill_rule, decimals_for(film.view.size())),
                   film.key_steps);
    markup += fmt::format("<path class=\"{}\"/>", rule.name);
    rules += format_rule(rule, animation);
  }
  return fmt::format("/* <svg viewBox=\"{}\">{}</svg> */\n{}", format_view_box(film.view), markup, rules);
}

/// What is shown is painted as the shapes are filled, or else as their lines are.
std::vector<StyleProperty> background_of(const Layer& layer) {
  const bool fills = layer.fills();
  StyleProperty background{"background", {}};
  StyleProperty opacity{"opacity", {}};
  for (const Style& key : layer.keys) {
    const Paint& paint = fills ? key.fill : key.stroke;
    background.values.push_back(color_text(paint));
    opacity.values.push_back(format_number(paint.opacity, kDecimals));
  }
  if (!opacity.changes() && opacity.values.front() == "1") return {background};
  return {background, opacity};
}

std::string format_clip_path(const Film& film, const AnimationOptions& animation, const CssOptions& options) {
  const Canvas canvas = canvas_of(film.view, options.size);
  const int precision = animation.precision >= 0 ? animation.precision : decimals_for(options.size);
  const KeyFrames& frames = film.frames;
  Rule rule{options.name, fmt::format("width: {}px; height: {}px;", canvas.width, canvas.height), {}};
  Track clip{options.name, film.steps, {}};
  for (const std::vector<CubicPath>& paths : frames.paths) {
    std::vector<CubicPath> drawn;
    for (std::size_t c = 0; c < paths.size(); ++c) {
      if (!paths[c].is_closed()) {
        throw InvalidArgument(
            fmt::format("css: contour {} is open, but clip-path shows only what contours enclose", c));
      }
      drawn.push_back(transform(paths[c], canvas.to_pixels));
    }
    clip.values.push_back(fmt::format("clip-path: path({}\"{}\");",
                                      frames.fill_rule == FillRule::evenodd ? "evenodd, " : "",
                                      format_path_data(drawn, frames.lines, precision)));
  }
  rule.tracks.push_back(std::move(clip));
  add_properties(rule, background_of(film.layers.front()), film.key_steps);
  return fmt::format("/* <div class=\"{}\"></div> */\n", options.name) + format_rule(rule, animation);
}

}  // namespace

bool is_css_name(std::string_view name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return !name.empty() && is_letter(name.front()) && std::all_of(name.begin(), name.end(), [&](char c) {
    return is_letter(c) || is_digit(c) || c == '-' || c == '_';
  });
}

std::string format_css(const PathMorph& morph, const AnimationOptions& animation, const CssOptions& options,
                       const Look& look) {
  check_animation(animation);
  if (!is_css_name(options.name)) {
    throw InvalidArgument(
        fmt::format("css: the name is '{}', expected a letter, then letters, digits, - and _", options.name));
  }
  const bool clip = options.property == CssProperty::clip_path;
  Film film;
  film.frames = key_frames(morph, {.tolerance = animation.tolerance, .bake_turn = clip});
  film.view = view_of(look, film.frames.box);
  film.layers = layers_of(morph, look, film.view, ink_paint());
  film.steps = forward_timeline(film.frames, animation);
  film.plain = look.styles.empty();
  film.key_steps = forward_timeline(keys_of(film.frames), animation);
  return clip ? format_clip_path(film, animation, options) : format_d(film, animation, options.name);
}

}  // namespace v0
}  // namespace tandem
