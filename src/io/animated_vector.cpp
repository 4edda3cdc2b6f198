#include "tandem/io/animated_vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/canvas.h"
#include "io/layers.h"
#include "io/number.h"
#include "io/timeline.h"
#include "tandem/io/path_data.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr double kLongerSide = 24.0;  // dp, as icons have it
constexpr int kDecimals = 6;          // of degrees and easings

/// What is animated of one part of the drawing: its name, and the values at the frames.
struct Target {
  std::string name;
  std::string property;
  std::string type;
  std::vector<std::string> values;  ///< [frame], or [key]
  bool by_key = false;

  [[nodiscard]] bool changes() const {
    return std::any_of(values.begin(), values.end(),
                       [&](const std::string& v) { return v != values.front(); });
  }
};

std::string interpolator(const Easing& easing) {
  if (easing.linear()) return " android:interpolator=\"@android:anim/linear_interpolator\"/>\n";
  return fmt::format(
      ">\n<aapt:attr name=\"android:interpolator\"><pathInterpolator android:controlX1=\"{}\" "
      "android:controlY1=\"{}\" android:controlX2=\"{}\" android:controlY2=\"{}\"/></aapt:attr>\n"
      "</objectAnimator>\n",
      format_number(easing.x1, kDecimals), format_number(easing.y1, kDecimals),
      format_number(easing.x2, kDecimals), format_number(easing.y2, kDecimals));
}

class VectorWriter {
 public:
  VectorWriter(const PathMorph& morph, const AnimationOptions& options, const Look& look)
      : frames_(key_frames(morph, {.tolerance = options.tolerance, .bake_turn = false})),
        steps_(forward_timeline(frames_, options)),
        key_steps_(forward_timeline(keys_of(frames_), options)),
        options_(options),
        view_(view_of(look, frames_.box)),
        layers_(layers_of(morph, look, view_, ink_paint())),
        precision_(decimals_for(view_, options.precision)) {}

  [[nodiscard]] std::string document() const {
    const std::vector<Target> targets = all_targets();
    const double unit = kLongerSide / view_.size();  // dp
    std::string text = fmt::format(
        "<animated-vector xmlns:android=\"http://schemas.android.com/apk/res/android\" "
        "xmlns:aapt=\"http://schemas.android.com/aapt\">\n<aapt:attr name=\"android:drawable\">\n"
        "<vector android:width=\"{}dp\" android:height=\"{}dp\" android:viewportWidth=\"{}\" "
        "android:viewportHeight=\"{}\">\n",
        format_number(view_.width * unit, 3), format_number(view_.height * unit, 3),
        format_number(view_.width, precision_), format_number(view_.height, precision_));
    text += drawing(targets);
    text += "</vector>\n</aapt:attr>\n";
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (i > 0 && targets[i].name == targets[i - 1].name) continue;
      std::vector<const Target*> properties;
      for (const Target& target : targets) {
        if (target.name == targets[i].name) properties.push_back(&target);
      }
      text += format_target(properties);
    }
    return text + "</animated-vector>\n";
  }

 private:
  // The drawing's origin is the view's corner.
  [[nodiscard]] Vec2 placed(Vec2 p) const { return {p.x - view_.x, p.y - view_.y}; }

  [[nodiscard]] std::vector<Target> all_targets() const {
    std::vector<Target> targets;
    if (!frames_.poses.empty()) {
      Target x{"frame", "translateX", "floatType", {}, false};
      Target y{"frame", "translateY", "floatType", {}, false};
      Target turn{"frame", "rotation", "floatType", {}, false};
      for (const FramePose& pose : frames_.poses) {
        const Vec2 p = placed(pose.center);
        x.values.push_back(format_number(p.x, precision_));
        y.values.push_back(format_number(p.y, precision_));
        turn.values.push_back(format_number(pose.degrees, kDecimals));
      }
      targets = {std::move(x), std::move(y), std::move(turn)};
    }
    const Vec2 corner = frames_.poses.empty() ? placed({0.0, 0.0}) : Vec2{};
    for (const Layer& layer : layers_) {
      Target path{layer.name, "pathData", "pathType", {}, false};
      for (const std::vector<CubicPath>& paths : frames_.paths) {
        std::vector<CubicPath> drawn;
        for (const std::size_t c : layer.contours) {
          drawn.push_back(transform(paths[c], Transform::translate(corner.x, corner.y)));
        }
        path.values.push_back(format_path_data(drawn, part_of(layer, frames_.lines), precision_));
      }
      targets.push_back(std::move(path));
      for (Target& target : style_targets(layer)) {
        if (target.changes()) targets.push_back(std::move(target));
      }
    }
    return targets;
  }

  /// What is drawn as it is at the keys. Android draws lines of no width as thin as it can: they get an
  /// opacity of 0.
  [[nodiscard]] std::vector<Target> style_targets(const Layer& layer) const {
    std::vector<Target> targets;
    const auto add = [&](const char* property, const char* type, const auto& value) {
      Target target{layer.name, property, type, {}, true};
      for (const Style& key : layer.keys) target.values.push_back(value(key));
      targets.push_back(std::move(target));
    };
    const auto number = [](double x, int precision) { return format_number(x, precision); };
    if (layer.fills()) {
      add("fillColor", "colorType", [](const Style& key) { return hex_of(key.fill); });
      add("fillAlpha", "floatType", [&](const Style& key) { return number(key.fill.opacity, kDecimals); });
    }
    if (layer.strokes()) {
      add("strokeColor", "colorType", [](const Style& key) { return hex_of(key.stroke); });
      add("strokeAlpha", "floatType", [&](const Style& key) {
        return number(key.stroke_width > 0.0 ? key.stroke.opacity : 0.0, kDecimals);
      });
      add("strokeWidth", "floatType",
          [&](const Style& key) { return number(key.stroke_width, decimals_for(view_.size())); });
    }
    return targets;
  }

  static std::string hex_of(const Paint& paint) {
    return color_text({Paint::Kind::color, rgb_of(paint), 1.0});
  }

  [[nodiscard]] std::string path_attributes(const Layer& layer) const {
    std::string text;
    for (const Target& target : style_targets(layer)) {
      const bool opaque = target.property.find("Alpha") != std::string::npos && target.values.front() == "1";
      if (!opaque || target.changes())
        text += fmt::format(" android:{}=\"{}\"", target.property, target.values.front());
    }
    if (layer.fills() && frames_.fill_rule == FillRule::evenodd) text += " android:fillType=\"evenOdd\"";
    if (!layer.strokes()) return text;
    const Style& first = layer.keys.front();
    if (first.line_cap != LineCap::butt) {
      text +=
          fmt::format(" android:strokeLineCap=\"{}\"", first.line_cap == LineCap::round ? "round" : "square");
    }
    if (first.line_join == LineJoin::miter) {
      text += fmt::format(" android:strokeMiterLimit=\"{}\"", format_number(first.miter_limit, kDecimals));
    } else {
      text += fmt::format(" android:strokeLineJoin=\"{}\"",
                          first.line_join == LineJoin::round ? "round" : "bevel");
    }
    return text;
  }

  /// The first frame.
  [[nodiscard]] std::string drawing(const std::vector<Target>& targets) const {
    std::string text;
    std::string group;
    for (const Target& target : targets) {
      if (target.name == "frame") {
        group += fmt::format(" android:{}=\"{}\"", target.property, target.values.front());
      } else if (target.property == "pathData") {
        const auto layer = std::find_if(layers_.begin(), layers_.end(),
                                        [&](const Layer& one) { return one.name == target.name; });
        text += fmt::format("<path android:name=\"{}\"{} android:pathData=\"{}\"/>\n", target.name,
                            path_attributes(*layer), target.values.front());
      }
    }
    if (group.empty()) return text;
    return fmt::format("<group android:name=\"frame\"{}>\n{}</group>\n", group, text);
  }

  [[nodiscard]] std::string format_target(const std::vector<const Target*>& properties) const {
    const bool set = properties.size() > 1 || steps_.size() > 2;
    std::string text = fmt::format("<target android:name=\"{}\">\n<aapt:attr name=\"android:animation\">\n{}",
                                   properties.front()->name, set ? "<set>\n" : "");
    for (const Target* target : properties) {
      const std::vector<TimelineStep>& steps = target->by_key ? key_steps_ : steps_;
      for (std::size_t i = 0; i + 1 < steps.size(); ++i) text += animator(*target, steps, i);
    }
    return text + (set ? "</set>\n" : "") + "</aapt:attr>\n</target>\n";
  }

  [[nodiscard]] std::string animator(const Target& target, const std::vector<TimelineStep>& steps,
                                     std::size_t step) const {
    const auto milliseconds = [&](std::size_t i) {
      return std::lround(1000.0 * options_.duration * steps[i].time);
    };
    std::string text = fmt::format(
        "<objectAnimator android:propertyName=\"{}\" android:valueType=\"{}\" android:startOffset=\"{}\" "
        "android:duration=\"{}\" android:valueFrom=\"{}\" android:valueTo=\"{}\"",
        target.property, target.type, milliseconds(step), milliseconds(step + 1) - milliseconds(step),
        target.values[step], target.values[step + 1]);
    if (steps_.size() == 2 && (options_.repeat || options_.alternate)) {
      text += fmt::format(" android:repeatCount=\"{}\" android:repeatMode=\"{}\"",
                          options_.repeat ? "infinite" : "1", options_.alternate ? "reverse" : "restart");
    }
    return text + interpolator(steps[step].easing);
  }

  KeyFrames frames_;
  std::vector<TimelineStep> steps_;
  std::vector<TimelineStep> key_steps_;
  const AnimationOptions& options_;
  View view_;
  std::vector<Layer> layers_;
  int precision_;
};

}  // namespace

std::string format_animated_vector(const PathMorph& morph, const AnimationOptions& options,
                                   const Look& look) {
  check_animation(options);
  return VectorWriter(morph, options, look).document();
}

}  // namespace v0
}  // namespace tandem
