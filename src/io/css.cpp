#include "tandem/io/css.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/canvas.h"
#include "io/ink.h"
#include "io/number.h"
#include "io/svg_parts.h"
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

/// One class: what it always is, and what it is at each frame.
struct Rule {
  std::string name;
  std::string constants;            ///< "a: b; c: d;"
  std::vector<std::string> frames;  ///< the same
};

std::string format_rule(const Rule& rule, const std::vector<TimelineStep>& steps,
                        const AnimationOptions& options) {
  const std::string times = options.repeat ? "infinite" : options.alternate ? "2" : "1";
  // The frames run one way: browsers turn them, and their timing functions, round by themselves.
  std::string text =
      fmt::format(".{0} {{ {1} {2} animation: {0} {3}s linear {4}{5} both; }}\n@keyframes {0} {{\n",
                  rule.name, rule.constants, rule.frames.front(), format_number(options.duration, kDecimals),
                  times, options.alternate ? " alternate" : "");
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string timing = steps[i].easing.linear() ? ""
                                                        : fmt::format(" animation-timing-function: {};",
                                                                      timing_function(steps[i].easing));
    text += fmt::format("  {}% {{ {}{} }}\n", format_number(100.0 * steps[i].time, kPercentDecimals),
                        rule.frames[i], timing);
  }
  return text +
         fmt::format("}}\n@media (prefers-reduced-motion: reduce) {{ .{} {{ animation: none; {} }} }}\n",
                     rule.name, rule.frames.back());
}

std::string format_d(const KeyFrames& frames, const std::vector<TimelineStep>& steps,
                     const AnimationOptions& animation, const std::string& name) {
  const View view = view_of(frames.box);
  const int precision = decimals_for(view, animation.precision);
  Rule filled{name,
              fmt::format("fill: {}; fill-rule: {};", kInk,
                          frames.fill_rule == FillRule::evenodd ? "evenodd" : "nonzero"),
              {}};
  Rule stroked{name + "-stroke",
               fmt::format("fill: none; stroke: {}; stroke-width: {}; stroke-linejoin: round;", kInk,
                           format_number(stroke_width(view), decimals_for(view.size()))),
               {}};
  bool any_filled = false;
  bool any_stroked = false;
  for (std::size_t i = 0; i < frames.paths.size(); ++i) {
    const PathDataParts parts = path_data_parts(frames.paths[i], frames.lines, precision);
    std::string pose;
    if (!frames.poses.empty()) {
      pose = fmt::format(" transform: translate({}px, {}px) rotate({}deg);",
                         format_number(frames.poses[i].center.x, precision),
                         format_number(frames.poses[i].center.y, precision),
                         format_number(frames.poses[i].degrees, kDecimals));
    }
    filled.frames.push_back(fmt::format("d: path(\"{}\");{}", parts.filled, pose));
    stroked.frames.push_back(fmt::format("d: path(\"{}\");{}", parts.stroked, pose));
    any_filled = any_filled || !parts.filled.empty();
    any_stroked = any_stroked || !parts.stroked.empty();
  }
  std::string markup;
  std::string rules;
  for (const Rule* rule : {&filled, &stroked}) {
    if (!(rule == &filled ? any_filled : any_stroked)) continue;
    markup += fmt::format("<path class=\"{}\"/>", rule->name);
    rules += format_rule(*rule, steps, animation);
  }
  return fmt::format("/* <svg viewBox=\"{}\">{}</svg> */\n{}", format_view_box(view), markup, rules);
}

std::string format_clip_path(const KeyFrames& frames, const std::vector<TimelineStep>& steps,
                             const AnimationOptions& animation, const CssOptions& options) {
  const Canvas canvas = canvas_of(view_of(frames.box), options.size);
  const int precision = animation.precision >= 0 ? animation.precision : decimals_for(options.size);
  Rule rule{options.name,
            fmt::format("width: {}px; height: {}px; background: {};", canvas.width, canvas.height, kInk),
            {}};
  for (const std::vector<CubicPath>& paths : frames.paths) {
    std::vector<CubicPath> drawn;
    for (std::size_t c = 0; c < paths.size(); ++c) {
      if (!paths[c].is_closed()) {
        throw InvalidArgument(
            fmt::format("css: contour {} is open, but clip-path shows only what contours enclose", c));
      }
      drawn.push_back(transform(paths[c], canvas.to_pixels));
    }
    rule.frames.push_back(fmt::format("clip-path: path({}\"{}\");",
                                      frames.fill_rule == FillRule::evenodd ? "evenodd, " : "",
                                      format_path_data(drawn, frames.lines, precision)));
  }
  return fmt::format("/* <div class=\"{}\"></div> */\n", options.name) + format_rule(rule, steps, animation);
}

}  // namespace

bool is_css_name(std::string_view name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return !name.empty() && is_letter(name.front()) && std::all_of(name.begin(), name.end(), [&](char c) {
    return is_letter(c) || is_digit(c) || c == '-' || c == '_';
  });
}

std::string format_css(const PathMorph& morph, const AnimationOptions& animation, const CssOptions& options) {
  check_animation(animation);
  if (!is_css_name(options.name)) {
    throw InvalidArgument(
        fmt::format("css: the name is '{}', expected a letter, then letters, digits, - and _", options.name));
  }
  const bool clip = options.property == CssProperty::clip_path;
  const KeyFrames frames = key_frames(morph, {.tolerance = animation.tolerance, .bake_turn = clip});
  const std::vector<TimelineStep> steps = forward_timeline(frames, animation);
  return clip ? format_clip_path(frames, steps, animation, options)
              : format_d(frames, steps, animation, options.name);
}

}  // namespace v0
}  // namespace tandem
