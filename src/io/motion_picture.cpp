#include "tandem/io/motion_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/easing.h"
#include "io/html.h"
#include "io/motion_page.h"
#include "io/number.h"
#include "io/page.h"
#include "io/timeline.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// Of a plot, in pixels, with room for its name and its numbers.
constexpr double kWidth = 420.0;
constexpr double kHeight = 150.0;
constexpr double kLeft = 52.0;
constexpr double kRight = 12.0;
constexpr double kTop = 26.0;
constexpr double kBottom = 22.0;
// Coordinates from which on plots stand in two columns.
constexpr std::size_t kTwoColumns = 4;
// Moments of every motion that lines are drawn through, evenly in its time: one per pixel.
constexpr std::size_t kMoments = 360;
constexpr int kHalvings = 40;  // to far less than a pixel
// Frames of a page per step of a smooth morph, which does not run straight from key to key.
constexpr std::size_t kSmoothFrames = 8;
constexpr int kDecimals = 2;

struct Range {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();
  void include(double x) {
    lo = std::min(lo, x);
    hi = std::max(hi, x);
  }
  /// Share of the way from lo to hi; in the middle when there is none.
  [[nodiscard]] double share(double x) const { return hi > lo ? (x - lo) / (hi - lo) : 0.5; }
};

/// An in-between: [coordinate][moment], the time first.
using Lines = std::vector<std::vector<double>>;

/// Parameters that are dense in the time of every motion: what takes long in one may be short in another.
std::vector<double> moments_of(const MotionMorph& morph) {
  std::vector<double> moments;
  for (const double s : morph.key_times()) {
    const Curve graph = morph.graph(s);
    const Interval domain = graph.domain();
    const Interval time = morph.duration(s);
    double from = domain.lo;
    for (std::size_t i = 0; i < kMoments; ++i) {
      const double wanted =
          time.lo + time.length() * static_cast<double>(i) / static_cast<double>(kMoments - 1);
      double lo = from;
      double hi = domain.hi;
      for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (lo + hi);
        (graph.evaluate(middle)[0] < wanted ? lo : hi) = middle;
      }
      from = lo;
      moments.push_back(i == 0 ? domain.lo : i + 1 == kMoments ? domain.hi : lo);
    }
  }
  std::sort(moments.begin(), moments.end());
  moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
  return moments;
}

Lines lines_at(const MotionMorph& morph, double s, const std::vector<double>& moments) {
  const Curve graph = morph.graph(s);
  Lines lines(static_cast<std::size_t>(graph.dim()));
  for (const double u : moments) {
    const Point p = graph.evaluate(u);
    for (std::size_t c = 0; c < lines.size(); ++c) lines[c].push_back(p[c]);
  }
  return lines;
}

/// A drawn motion.
struct Drawn {
  double s;
  bool key;
  Lines lines;
};

std::vector<double> in_betweens_of(const MotionMorph& morph, const MotionPicture& picture) {
  if (!picture.in_betweens.empty()) return picture.in_betweens;
  std::vector<double> all;
  const std::vector<double>& times = morph.key_times();
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    for (const double local : {0.25, 0.5, 0.75})
      all.push_back((1.0 - local) * times[k] + local * times[k + 1]);
  }
  return all;
}

std::vector<Drawn> drawn_of(const MotionMorph& morph, const MotionPicture& picture) {
  const std::vector<double> moments = moments_of(morph);
  std::vector<Drawn> drawn;
  for (const double s : in_betweens_of(morph, picture))
    drawn.push_back({s, false, lines_at(morph, s, moments)});
  for (const double s : morph.key_times()) drawn.push_back({s, true, lines_at(morph, s, moments)});
  return drawn;
}

std::vector<Range> ranges_of(const std::vector<Lines>& all) {
  std::vector<Range> ranges(all.front().size());
  for (const Lines& lines : all) {
    for (std::size_t c = 0; c < ranges.size(); ++c) {
      for (const double x : lines[c]) ranges[c].include(x);
    }
  }
  return ranges;
}

void check(const MotionMorph& morph, const MotionPicture& picture) {
  const auto wanted = static_cast<std::size_t>(morph.dim()) + 1;
  if (picture.columns.size() == wanted) return;
  throw InvalidArgument(
      fmt::format("motion picture: {} names, expected {}: of the time and of each coordinate",
                  picture.columns.size(), wanted));
}

/// From blue to orange.
std::string tint(double s) {
  const double share = std::clamp(s, 0.0, 1.0);
  const auto mixed = [&](double from, double to) { return std::lround((1.0 - share) * from + share * to); };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(0x3f, 0xc2), mixed(0x62, 0x56), mixed(0xc8, 0x2f));
}

std::string path_of(const Lines& lines, std::size_t coordinate, const Range& time, const Range& range) {
  std::string text = "M";
  for (std::size_t i = 0; i < lines[0].size(); ++i) {
    if (i > 0) text += 'L';
    append_number(text, kLeft + (kWidth - kLeft - kRight) * time.share(lines[0][i]), kDecimals);
    text += ' ';
    append_number(text, kHeight - kBottom - (kHeight - kTop - kBottom) * range.share(lines[coordinate][i]),
                  kDecimals);
  }
  return text;
}

std::string number_text(double x, const Range& range) {
  const double size = std::max(std::fabs(range.lo), std::fabs(range.hi));
  const int digits = size > 0.0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 9) : 0;
  return format_number(x, digits);
}

/// A plot without its lines.
std::string frame_of(const std::string& name, const std::string& time_name, const Range& time,
                     const Range& range) {
  const double right = kWidth - kRight;
  const double low = kHeight - kBottom;
  const auto label = [](double x, double y, const char* anchor, const std::string& text) {
    return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                       escape_html(text));
  };
  std::string text =
      fmt::format("<text class=\"name\" x=\"{}\" y=\"16\">{}</text>\n", kLeft, escape_html(name));
  text += fmt::format("<path class=\"box\" d=\"M{0} {1}H{2}V{3}H{0}Z\"/>\n", kLeft, kTop, right, low);
  if (range.lo < 0.0 && range.hi > 0.0) {
    const double zero = low - (low - kTop) * range.share(0.0);
    text +=
        fmt::format("<path class=\"zero\" d=\"M{} {}H{}\"/>\n", kLeft, format_number(zero, kDecimals), right);
  }
  text += label(kLeft - 5, kTop + 4, "end", number_text(range.hi, range));
  text += label(kLeft - 5, low + 4, "end", number_text(range.lo, range));
  text += label(kLeft, low + 15, "start", number_text(time.lo, time));
  text += label(right, low + 15, "end", number_text(time.hi, time));
  return text + label(0.5 * (kLeft + right), low + 15, "middle", time_name);
}

std::size_t columns_for(std::size_t plots) {
  return plots >= kTwoColumns ? 2 : 1;
}

constexpr const char* kStyle =
    "text { font: 11px system-ui, sans-serif; fill: #6d7482 } .name { font-weight: 600; fill: #1f2733 }\n"
    ".box { fill: none; stroke: #d8d4cc } .zero { fill: none; stroke: #d8d4cc; stroke-dasharray: 3 3 }\n"
    ".motion { fill: none; stroke-width: 2; stroke-linejoin: round } .between { stroke-width: 1; opacity: "
    "0.75 }\n";

std::string number_list(const std::vector<double>& values, const Range& range) {
  // A ten-thousandth of the range is less than a pixel.
  const double step = std::max((range.hi - range.lo) * 1e-4, std::numeric_limits<double>::min());
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(step))), 0, 15);
  std::string text = "[";
  for (const double x : values) {
    if (text.size() > 1) text += ',';
    append_number(text, x, digits);
  }
  return text + "]";
}

/// s of the frames from each to the next of which the page blends evenly, and which are the keys.
std::vector<double> frame_times(const MotionMorph& morph, bool smooth, std::vector<std::size_t>& keys) {
  const std::vector<double>& times = morph.key_times();
  const std::size_t parts = smooth ? kSmoothFrames : 1;
  std::vector<double> all;
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    keys.push_back(all.size());
    for (std::size_t i = 0; i < parts; ++i) {
      const double local = static_cast<double>(i) / static_cast<double>(parts);
      all.push_back((1.0 - local) * times[k] + local * times[k + 1]);
    }
  }
  keys.push_back(all.size());
  all.push_back(1.0);
  return all;
}

}  // namespace

std::string format_motion_svg(const MotionMorph& morph, const MotionPicture& picture) {
  check(morph, picture);
  const std::vector<Drawn> drawn = drawn_of(morph, picture);
  std::vector<Lines> all;
  for (const Drawn& motion : drawn) all.push_back(motion.lines);
  const std::vector<Range> ranges = ranges_of(all);
  const std::size_t plots = ranges.size() - 1;
  const std::size_t columns = columns_for(plots);
  const std::size_t rows = (plots + columns - 1) / columns;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
      "<title>{2}</title>\n<style>{3}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fffefb\"/>\n",
      kWidth * static_cast<double>(columns), kHeight * static_cast<double>(rows), escape_html(picture.title),
      kStyle);
  for (std::size_t c = 1; c < ranges.size(); ++c) {
    text +=
        fmt::format("<g transform=\"translate({} {})\">\n", kWidth * static_cast<double>((c - 1) % columns),
                    kHeight * static_cast<double>((c - 1) / columns));
    text += frame_of(picture.columns[c], picture.columns[0], ranges[0], ranges[c]);
    for (const Drawn& motion : drawn) {
      text += fmt::format("<path class=\"motion{}\" stroke=\"{}\" d=\"{}\"/>\n", motion.key ? "" : " between",
                          tint(motion.s), path_of(motion.lines, c, ranges[0], ranges[c]));
    }
    text += "</g>\n";
  }
  return text + "</svg>\n";
}

std::string format_motion_html(const MotionMorph& morph, const MotionPicture& picture,
                               const AnimationOptions& options) {
  check(morph, picture);
  check_animation(options);
  KeyFrames frames;
  frames.smooth = morph.is_smooth();
  frames.times = frame_times(morph, frames.smooth, frames.keys);
  const std::vector<Easing> easings = parse_easings(options.easing, frames.keys.size() - 1);
  const std::vector<double> moments = moments_of(morph);
  std::vector<Lines> all;
  for (const double s : frames.times) all.push_back(lines_at(morph, s, moments));
  const std::vector<Range> ranges = ranges_of(all);
  std::string data = fmt::format(
      "{{\"times\":[{}],\"keys\":[{}],\"stretches\":[{}],\"easings\":[{}],\"duration\":{},\"alternate\":{},"
      "\"repeat\":{},\"plot\":[{},{},{},{}],\"ranges\":[",
      fmt::join(frames.times, ","), fmt::join(frames.keys, ","),
      fmt::join(eased_stretches(frames, easings), ","), format_easings(easings),
      format_number(options.duration), options.alternate, options.repeat, kLeft, kTop, kWidth - kRight,
      kHeight - kBottom);
  for (std::size_t c = 0; c < ranges.size(); ++c) {
    data +=
        fmt::format("{}[{},{}]", c == 0 ? "" : ",", format_number(ranges[c].lo), format_number(ranges[c].hi));
  }
  data += "],\"frames\":[";
  for (std::size_t i = 0; i < all.size(); ++i) {
    data += i == 0 ? "\n[" : ",\n[";
    for (std::size_t c = 0; c < ranges.size(); ++c)
      data += (c == 0 ? "" : ",") + number_list(all[i][c], ranges[c]);
    data += "]";
  }
  data += "]}";
  std::string plots;
  for (std::size_t c = 1; c < ranges.size(); ++c) {
    plots += fmt::format("<svg class=\"plot\" viewBox=\"0 0 {} {}\">\n{}</svg>\n", kWidth, kHeight,
                         frame_of(picture.columns[c], picture.columns[0], ranges[0], ranges[c]));
  }
  const std::string body =
      "<div class=\"plots\">\n" + plots + "</div>\n" + play_bar("Position s between the motions");
  return format_page({picture.title, kMotionStyle, body, data, play_script() + kMotionScript});
}

}  // namespace v0
}  // namespace tandem
