#include <fmt/format.h>

#include <algorithm>

#include "io/layers.h"
#include "io/number.h"
#include "io/style_properties.h"
#include "io/timeline.h"
#include "tandem/io/path_data.h"
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

std::string group_attribute(const FramePose& pose, int precision) {
  return fmt::format(" transform=\"translate({} {}) rotate({})\"", format_number(pose.center.x, precision),
                     format_number(pose.center.y, precision), format_number(pose.degrees, kDecimals));
}

class AnimationWriter {
 public:
  AnimationWriter(const PathMorph& morph, const AnimationOptions& options, const Look& look)
      // A browser turns and moves groups evenly by itself, to the dot.
      : frames_(key_frames(morph, {.tolerance = options.tolerance, .bake_turn = false})),
        view_(view_of(look, frames_.box)),
        precision_(decimals_for(view_, options.precision)),
        layers_(layers_of(morph, look, view_, ink_paint())),
        steps_(loop_timeline(frames_, options)),
        when_(timing(steps_, options)),
        key_steps_(loop_timeline(keys_of(frames_), options)),
        keys_when_(timing(key_steps_, options)) {}

  [[nodiscard]] std::string document() const {
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{}\">\n{}<g class=\"tandem-moving\">\n",
        format_view_box(view_), kReducedMotion);
    if (!frames_.poses.empty()) text += opened_frame();
    for (const Layer& layer : layers_) text += moving(layer);
    if (!frames_.poses.empty()) text += "</g></g>\n";
    return text + "</g>\n" + still() + "</svg>\n";
  }

 private:
  [[nodiscard]] std::string opened_frame() const {
    const auto group = [&](const char* type, const auto& value) {
      const std::string values =
          joined(steps_.size(), [&](std::size_t i) { return value(frames_.poses[steps_[i].frame]); });
      return fmt::format(
          "<g transform=\"{0}({1})\">\n<animateTransform attributeName=\"transform\" type=\"{0}\" {2} "
          "values=\"{3}\"/>\n",
          type, value(frames_.poses.front()), when_, values);
    };
    return group("translate",
                 [&](const FramePose& pose) {
                   return format_number(pose.center.x, precision_) + " " +
                          format_number(pose.center.y, precision_);
                 }) +
           group("rotate", [](const FramePose& pose) { return format_number(pose.degrees, kDecimals); });
  }

  [[nodiscard]] std::string data(const Layer& layer, std::size_t frame) const {
    return format_path_data(part_of(layer, frames_.paths[frame]), part_of(layer, frames_.lines), precision_);
  }

  [[nodiscard]] std::vector<StyleProperty> properties(const Layer& layer) const {
    return style_properties(layer.keys, frames_.fill_rule, decimals_for(view_.size()));
  }

  [[nodiscard]] std::string moving(const Layer& layer) const {
    std::vector<std::string> d;
    for (std::size_t frame = 0; frame < frames_.paths.size(); ++frame) d.push_back(data(layer, frame));
    const auto animate = [](const std::string& name, const std::string& when, const std::string& values) {
      return fmt::format("<animate attributeName=\"{}\" {} values=\"{}\"/>\n", name, when, values);
    };
    const std::vector<StyleProperty> drawn = properties(layer);
    std::string text = fmt::format("<path {}d=\"{}\">\n", attributes_text(drawn), d.front());
    text += animate("d", when_, joined(steps_.size(), [&](std::size_t i) { return d[steps_[i].frame]; }));
    for (const StyleProperty& property : drawn) {
      if (!property.changes()) continue;
      text += animate(property.name, keys_when_, joined(key_steps_.size(), [&](std::size_t i) {
                        return property.values[key_steps_[i].frame];
                      }));
    }
    return text + "</path>\n";
  }

  /// The last key at rest.
  [[nodiscard]] std::string still() const {
    std::string text = "<g class=\"tandem-still\" display=\"none\"";
    if (!frames_.poses.empty()) text += group_attribute(frames_.poses.back(), precision_);
    text += ">\n";
    for (const Layer& layer : layers_) {
      text += fmt::format("<path {}d=\"{}\"/>\n", attributes_text(properties(layer), layer.keys.size() - 1),
                          data(layer, frames_.paths.size() - 1));
    }
    return text + "</g>\n";
  }

  KeyFrames frames_;
  View view_;
  int precision_;
  std::vector<Layer> layers_;
  std::vector<TimelineStep> steps_;
  std::string when_;
  std::vector<TimelineStep> key_steps_;
  std::string keys_when_;
};

}  // namespace

std::string format_animated_svg(const PathMorph& morph, const AnimationOptions& options, const Look& look) {
  check_animation(options);
  return AnimationWriter(morph, options, look).document();
}

}  // namespace v0
}  // namespace tandem
