#include "tandem/io/lottie.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/canvas.h"
#include "io/layers.h"
#include "io/limits.h"
#include "io/number.h"
#include "io/timeline.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr double kFramesPerSecond = 60.0;
constexpr int kDecimals = 6;      // of degrees, colours and easings
constexpr int kTimeDecimals = 3;  // of frames

std::string pair(double x, double y, int precision) {
  return fmt::format("[{},{}]", format_number(x, precision), format_number(y, precision));
}

std::string easing_text(const Easing& easing, bool in_lists) {
  const auto number = [&](double x) {
    return in_lists ? fmt::format("[{}]", format_number(x, kDecimals)) : format_number(x, kDecimals);
  };
  return fmt::format("\"o\":{{\"x\":{},\"y\":{}}},\"i\":{{\"x\":{},\"y\":{}}}", number(easing.x1),
                     number(easing.y1), number(easing.x2), number(easing.y2));
}

/// {"a":1,"k":[...]}: value(frame) at every step. in_lists: how components of numbers are timed, other than
/// those of places and paths.
template <class Value>
std::string animated(const std::vector<TimelineStep>& steps, double length, bool in_lists,
                     const Value& value) {
  std::string text = "{\"a\":1,\"k\":[";
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool last = i + 1 == steps.size();
    text += fmt::format("{}{{\"t\":{},\"s\":{}{}{}}}", i == 0 ? "" : ",",
                        format_number(steps[i].time * length, kTimeDecimals), value(steps[i].frame),
                        last ? "" : ",", last ? "" : easing_text(steps[i].easing, in_lists));
  }
  return text + "]}";
}

// Players do not agree on loops of a single vertex: it gets a second one, half-way.
CubicPath halved(const CubicPath& path) {
  const auto p = path.segment(0);
  const auto middle = [](std::span<const double> a, std::span<const double> b) {
    return Point{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
  };
  const Point a = middle(p[0], p[1]);
  const Point b = middle(p[1], p[2]);
  const Point c = middle(p[2], p[3]);
  const Point ab = middle(a, b);
  const Point bc = middle(b, c);
  Points points;
  points.push_back(p[0]);
  for (const Point& q : {a, ab, middle(ab, bc), bc, c}) points.push_back(q);
  points.push_back(p[3]);
  return CubicPath(std::move(points), path.is_closed());
}

/// Vertices, and the handles before and behind each, relative to it. A line needs none.
std::string vertices(const CubicPath& path, const std::vector<bool>& lines, int precision) {
  const Points& points = path.control_points();
  const std::size_t segments = path.segment_count();
  const std::size_t count = segments + (path.is_closed() ? 0 : 1);
  std::string v, in, out;
  for (std::size_t i = 0; i < count; ++i) {
    const auto p = points[3 * i];
    const auto handle = [&](std::size_t segment, std::size_t index) {
      if (segment >= segments || lines[segment]) return std::string("[0,0]");
      const auto end = points[index < 3 * segment + 2 ? 3 * segment : 3 * segment + 3];
      return pair(points[index][0] - end[0], points[index][1] - end[1], precision);
    };
    // The segment before the first vertex is the last one of a closed path; an open path has none.
    const std::size_t before = i > 0 ? i - 1 : path.is_closed() ? segments - 1 : segments;
    const char* const comma = i == 0 ? "" : ",";
    v += comma + pair(p[0], p[1], precision);
    in += comma + handle(before, 3 * before + 2);
    out += comma + handle(i, 3 * i + 1);
  }
  return fmt::format("[{{\"c\":{},\"v\":[{}],\"i\":[{}],\"o\":[{}]}}]", path.is_closed(), v, in, out);
}

class LottieWriter {
 public:
  LottieWriter(const PathMorph& morph, const AnimationOptions& options, int size, const Look& look)
      : frames_(key_frames(morph, {.tolerance = options.tolerance, .bake_turn = false})),
        steps_(loop_timeline(frames_, options)),
        key_steps_(loop_timeline(keys_of(frames_), options)),
        view_(view_of(look, frames_.box)),
        layers_(layers_of(morph, look, view_, ink_paint())),
        canvas_(canvas_of(view_, size)),
        // Players count whole frames.
        length_(std::max(1.0, std::round(loop_seconds(options) * kFramesPerSecond))),
        precision_(options.precision >= 0 ? options.precision : decimals_for(size)) {}

  [[nodiscard]] std::string document(const std::string& title) const {
    const std::string name =
        nlohmann::json(title).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    return fmt::format(
        "{{\"v\":\"5.7.0\",\"fr\":{0},\"ip\":0,\"op\":{1},\"w\":{2},\"h\":{3},\"nm\":{4},\"ddd\":0,"
        "\"assets\":[],"
        "\"layers\":[\n{{\"ddd\":0,\"ind\":1,\"ty\":4,\"nm\":{4},\"sr\":1,\"ks\":{5},\"ao\":0,\"shapes\":[\n{"
        "6}],"
        "\"ip\":0,\"op\":{1},\"st\":0,\"bm\":0}}]}}\n",
        format_number(kFramesPerSecond), format_number(length_), canvas_.width, canvas_.height, name,
        transform_text(), groups());
  }

 private:
  // The moving frame moves the layer, whose shapes are as the frame sees them.
  [[nodiscard]] std::string transform_text() const {
    std::string place = "{\"a\":0,\"k\":[0,0,0]}";
    std::string turn = "{\"a\":0,\"k\":0}";
    if (!frames_.poses.empty()) {
      place = animated(steps_, length_, false, [&](std::size_t frame) {
        const FramePose& pose = frames_.poses[frame];
        const Vec2 p = canvas_.to_pixels(pose.center);
        return fmt::format("[{},{},0]", format_number(p.x, precision_), format_number(p.y, precision_));
      });
      turn = animated(steps_, length_, true, [&](std::size_t frame) {
        return fmt::format("[{}]", format_number(frames_.poses[frame].degrees, kDecimals));
      });
    }
    return fmt::format(
        "{{\"o\":{{\"a\":0,\"k\":100}},\"r\":{},\"p\":{},\"a\":{{\"a\":0,\"k\":[0,0,0]}},"
        "\"s\":{{\"a\":0,\"k\":[100,100,100]}}}}",
        turn, place);
  }

  [[nodiscard]] std::string groups() const {
    std::string text;
    // What stands first is drawn on top.
    for (std::size_t i = layers_.size(); i-- > 0;) text += group(layers_[i]) + (i == 0 ? "" : ",\n");
    return text;
  }

  /// Contours and how they are painted.
  [[nodiscard]] std::string group(const Layer& layer) const {
    std::string shapes;
    for (const std::size_t c : layer.contours) {
      shapes += fmt::format("{{\"ty\":\"sh\",\"nm\":\"Contour {}\",\"ks\":{}}},\n", c + 1, path_text(c));
    }
    if (layer.strokes()) shapes += stroke_text(layer) + ",\n";
    if (layer.fills()) {
      shapes += fmt::format("{{\"ty\":\"fl\",{},\"r\":{},\"bm\":0,\"nm\":\"Fill\"}},\n",
                            paint_text(layer, &Style::fill), frames_.fill_rule == FillRule::evenodd ? 2 : 1);
    }
    std::string name = layer.name;
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
    return fmt::format(
        "{{\"ty\":\"gr\",\"nm\":\"{}\",\"it\":[\n{}{{\"ty\":\"tr\",\"p\":{{\"a\":0,\"k\":[0,0]}},"
        "\"a\":{{\"a\":0,\"k\":[0,0]}},\"s\":{{\"a\":0,\"k\":[100,100]}},\"r\":{{\"a\":0,\"k\":0}},"
        "\"o\":{{\"a\":0,\"k\":100}}}}]}}",
        name, shapes);
  }

  /// {"a":0,"k":...} of what every key has, key frames of the rest. component: a number or a list of them.
  template <class Component>
  [[nodiscard]] std::string by_key(const Layer& layer, const Component& component) const {
    std::vector<std::string> values;
    bool one = true;
    for (const Style& key : layer.keys) {
      values.push_back(component(key));
      one = one && values.back() == values.front();
    }
    if (one) return fmt::format("{{\"a\":0,\"k\":{}}}", values.front());
    return animated(key_steps_, length_, true, [&](std::size_t key) {
      return values[key].front() == '[' ? values[key] : '[' + values[key] + ']';
    });
  }

  [[nodiscard]] std::string paint_text(const Layer& layer, Paint Style::*paint) const {
    constexpr double kWhite = 255.0;
    const std::string color = by_key(layer, [&](const Style& key) {
      const std::array<double, 3> rgb = rgb_of(key.*paint);
      return fmt::format("[{},{},{},1]", format_number(rgb[0] / kWhite, kDecimals),
                         format_number(rgb[1] / kWhite, kDecimals),
                         format_number(rgb[2] / kWhite, kDecimals));
    });
    const std::string opacity = by_key(
        layer, [&](const Style& key) { return format_number(100.0 * (key.*paint).opacity, kTimeDecimals); });
    return fmt::format("\"c\":{},\"o\":{}", color, opacity);
  }

  [[nodiscard]] std::string stroke_text(const Layer& layer) const {
    const Style& first = layer.keys.front();
    // Both count from 1: butt, round, square; miter, round, bevel.
    std::string text = fmt::format(
        "{{\"ty\":\"st\",{},\"w\":{},\"lc\":{},\"lj\":{},", paint_text(layer, &Style::stroke),
        by_key(layer,
               [&](const Style& key) {
                 return format_number(std::min(key.stroke_width * canvas_.scale(), kLargestCoordinate),
                                      kTimeDecimals);
               }),
        static_cast<int>(first.line_cap) + 1, static_cast<int>(first.line_join) + 1);
    if (first.line_join == LineJoin::miter) {
      text += fmt::format("\"ml\":{},", format_number(first.miter_limit, kTimeDecimals));
    }
    return text + "\"bm\":0,\"nm\":\"Stroke\"}";
  }

  [[nodiscard]] std::string path_text(std::size_t contour) const {
    // In a layer that moves, shapes are about its origin: scaled only.
    Transform map = canvas_.to_pixels;
    if (!frames_.poses.empty()) map = Transform::scale(canvas_.scale(), canvas_.scale());
    const bool loop =
        frames_.paths.front()[contour].segment_count() == 1 && frames_.paths.front()[contour].is_closed();
    std::vector<bool> lines = frames_.lines[contour];
    if (loop) lines.assign(2, lines.front());
    return animated(steps_, length_, false, [&](std::size_t frame) {
      const CubicPath& path = frames_.paths[frame][contour];
      return vertices(transform(loop ? halved(path) : path, map), lines, precision_);
    });
  }

  KeyFrames frames_;
  std::vector<TimelineStep> steps_;
  std::vector<TimelineStep> key_steps_;
  View view_;
  std::vector<Layer> layers_;
  Canvas canvas_;
  double length_;  // in frames
  int precision_;
};

}  // namespace

std::string format_lottie(const PathMorph& morph, const std::string& title, const AnimationOptions& options,
                          int size, const Look& look) {
  check_animation(options);
  return LottieWriter(morph, options, size, look).document(title);
}

}  // namespace v0
}  // namespace tandem
