#include "tandem/io/animated_vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/canvas.h"
#include "io/ink.h"
#include "io/number.h"
#include "io/svg_parts.h"
#include "io/timeline.h"

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
  std::vector<std::string> values;  ///< [frame]
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
  VectorWriter(const KeyFrames& frames, const AnimationOptions& options)
      : frames_(frames),
        steps_(forward_timeline(frames, options)),
        options_(options),
        view_(view_of(frames.box)),
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
      Target x{"frame", "translateX", "floatType", {}};
      Target y{"frame", "translateY", "floatType", {}};
      Target turn{"frame", "rotation", "floatType", {}};
      for (const FramePose& pose : frames_.poses) {
        const Vec2 p = placed(pose.center);
        x.values.push_back(format_number(p.x, precision_));
        y.values.push_back(format_number(p.y, precision_));
        turn.values.push_back(format_number(pose.degrees, kDecimals));
      }
      targets = {std::move(x), std::move(y), std::move(turn)};
    }
    const Vec2 corner = frames_.poses.empty() ? placed({0.0, 0.0}) : Vec2{};
    Target filled{"filled", "pathData", "pathType", {}};
    Target stroked{"stroked", "pathData", "pathType", {}};
    for (const std::vector<CubicPath>& paths : frames_.paths) {
      std::vector<CubicPath> drawn;
      drawn.reserve(paths.size());
      for (const CubicPath& path : paths) {
        drawn.push_back(transform(path, Transform::translate(corner.x, corner.y)));
      }
      PathDataParts parts = path_data_parts(drawn, frames_.lines, precision_);
      filled.values.push_back(std::move(parts.filled));
      stroked.values.push_back(std::move(parts.stroked));
    }
    for (Target* target : {&filled, &stroked}) {
      if (!target->values.front().empty()) targets.push_back(std::move(*target));
    }
    return targets;
  }

  /// The first frame.
  [[nodiscard]] std::string drawing(const std::vector<Target>& targets) const {
    std::string text;
    std::string group;
    for (const Target& target : targets) {
      const std::string& value = target.values.front();
      if (target.name == "frame") {
        group += fmt::format(" android:{}=\"{}\"", target.property, value);
      } else if (target.name == "filled") {
        text += fmt::format(
            "<path android:name=\"filled\" android:fillColor=\"{}\"{} android:pathData=\"{}\"/>\n", kInk,
            frames_.fill_rule == FillRule::evenodd ? " android:fillType=\"evenOdd\"" : "", value);
      } else {
        text += fmt::format(
            "<path android:name=\"stroked\" android:strokeColor=\"{}\" android:strokeWidth=\"{}\" "
            "android:strokeLineJoin=\"round\" android:pathData=\"{}\"/>\n",
            kInk, format_number(stroke_width(view_), decimals_for(view_.size())), value);
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
      for (std::size_t i = 0; i + 1 < steps_.size(); ++i) text += animator(*target, i);
    }
    return text + (set ? "</set>\n" : "") + "</aapt:attr>\n</target>\n";
  }

  [[nodiscard]] std::string animator(const Target& target, std::size_t step) const {
    const auto milliseconds = [&](std::size_t i) {
      return std::lround(1000.0 * options_.duration * steps_[i].time);
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
    return text + interpolator(steps_[step].easing);
  }

  const KeyFrames& frames_;
  std::vector<TimelineStep> steps_;
  const AnimationOptions& options_;
  View view_;
  int precision_;
};

}  // namespace

std::string format_animated_vector(const PathMorph& morph, const AnimationOptions& options) {
  check_animation(options);
  const KeyFrames frames = key_frames(morph, {.tolerance = options.tolerance, .bake_turn = false});
  return VectorWriter(frames, options).document();
}

}  // namespace v0
}  // namespace tandem
