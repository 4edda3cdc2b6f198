#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "io/easing.h"
#include "io/html.h"
#include "io/html_player_page.h"
#include "io/number.h"
#include "io/svg_parts.h"
#include "tandem/error.h"
#include "tandem/io/svg.h"

namespace tandem {
inline namespace v0 {
namespace {

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

std::string contour_data(const PathContour& contour, int precision) {
  std::string commands;
  for (const bool line : contour.lines) commands += line ? 'L' : 'C';
  std::string text = fmt::format("{{\"closed\":{},\"commands\":\"{}\",\"keys\":[",
                                 contour.keys.front().is_closed(), commands);
  for (std::size_t key = 0; key < contour.keys.size(); ++key) {
    if (key > 0) text += ",\n";
    text += numbers(contour.keys[key], contour.lines, precision);
  }
  return text + "]}";
}

// [x, y, degrees] of the frame at every key.
std::string pose_data(const PathMorph& morph, int precision) {
  constexpr int kAngleDecimals = 6;
  std::string text = "[";
  for (const FramePose& pose : morph.poses()) {
    if (text.size() > 1) text += ',';
    text += fmt::format("[{},{},{}]", format_number(pose.center.x, precision),
                        format_number(pose.center.y, precision), format_number(pose.degrees, kAngleDecimals));
  }
  return text + "]";
}

std::string morph_data(const PathMorph& morph, const AnimationOptions& options) {
  const View view = view_of(morph.box());
  const int precision = decimals_for(view.size());
  const Easing easing = parse_easing(options.easing);
  std::string text = fmt::format(
      "{{\"keys\":{},\"view\":[{},{},{},{}],\"rule\":\"{}\",\"duration\":{},\"alternate\":{},"
      "\"easing\":[{},{},{},{}],\n\"contours\":[",
      morph.key_count(), format_number(view.x, precision), format_number(view.y, precision),
      format_number(view.width, precision), format_number(view.height, precision),
      morph.fill_rule() == FillRule::evenodd ? "evenodd" : "nonzero", format_number(options.duration),
      options.alternate, format_number(easing.x1), format_number(easing.y1), format_number(easing.x2),
      format_number(easing.y2));
  for (std::size_t c = 0; c < morph.contours().size(); ++c) {
    if (c > 0) text += ",\n";
    text += contour_data(morph.contours()[c], precision);
  }
  text += ']';
  if (morph.turns()) text += ",\n\"poses\":" + pose_data(morph, precision);
  return text + '}';
}

}  // namespace

std::string format_html_player(const PathMorph& morph, const std::string& title,
                               const AnimationOptions& options) {
  if (!(options.duration > 0.0 && std::isfinite(options.duration))) {
    throw InvalidArgument(fmt::format("player: duration is {} s, expected > 0", options.duration));
  }
  std::string page = replace_all(kPlayerHead, "%TITLE%", escape_html(title));
  page += "<script type=\"application/json\" id=\"morph\">\n" + morph_data(morph, options) + "\n</script>\n";
  return page + kPlayerScript;
}

}  // namespace v0
}  // namespace tandem
