#include "tandem/io/match_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/match_picture_parts.h"
#include "io/number.h"
#include "tandem/match/rotation.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr double kWidth = 1180.0;
constexpr double kHeight = 640.0;
constexpr Frame kLinks{36.0, 92.0, 560.0, 512.0};
constexpr Frame kTable{664.0, 92.0, 480.0, 480.0};

const char* method_name(Method method) {
  switch (method) {
    case Method::paper:
      return "paper";
    case Method::segments:
      return "segments";
    case Method::elastic:
      break;
  }
  return "elastic";
}

std::string title(const MatchReport& report) {
  return fmt::format("{} method, {} norm", method_name(report.method), report.norm);
}

std::string verdict(const MatchReport& report) {
  const Validity& validity = report.validity;
  if (validity.valid) return fmt::format("valid, least product of tangents {:.3f}", validity.min_dot);
  return fmt::format("valid on {:.1f} % of the length only, least product of tangents {:.3f}",
                     100.0 * validity.valid_share, validity.min_dot);
}

/// 0 for a match that was cancelled, which has no rotation.
double turn_degrees(const MatchReport& report, int dim) {
  return report.rotation.empty() ? 0.0 : Rotation(dim, report.rotation).degrees();
}

std::string details(const MatchReport& report, int dim) {
  std::string text = fmt::format("cost {:.6g} (mean {:.4g}), {} x {} nodes, {}", report.cost,
                                 report.mean_cost, report.samples[0], report.samples[1],
                                 report.direction == Direction::reversed ? "reversed" : "forward");
  if (report.shift != 0) text += fmt::format(", shift {}", report.shift);
  const double degrees = turn_degrees(report, dim);
  if (degrees != 0.0) text += fmt::format(", turned by {:.4g}\u00b0", degrees);
  return text;
}

std::string legend(double x, double y, const char* style, const char* label) {
  return fmt::format("<path d=\"M{} {}h22\" {}/>\n<text class=\"small\" x=\"{}\" y=\"{}\">{}</text>\n",
                     pixels(x), pixels(y - 4.0), style, pixels(x + 30.0), pixels(y), label);
}

}  // namespace

std::string color(double red, double green, double blue) {
  const auto byte = [](double x) { return static_cast<int>(std::lround(255.0 * std::clamp(x, 0.0, 1.0))); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(red), byte(green), byte(blue));
}

std::string pixels(double x) {
  return format_number(x, 2);
}

std::string format_match_picture(const Curve& a, const Curve& b, const Match& match,
                                 const MatchOptions& options) {
  const MatchReport& report = match.report;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
      "<style>text{{font-family:system-ui,'Helvetica Neue',Arial,sans-serif;fill:#232a36}}"
      ".title{{font-size:20px;font-weight:600}}.small{{font-size:13px;fill:#5d6675}}"
      ".verdict{{font-size:13px;fill:{2}}}</style>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      kWidth, kHeight, report.validity.valid ? "#2c7a4b" : "#b5482a");
  text += fmt::format("<text class=\"title\" x=\"36\" y=\"44\">{}</text>\n", title(report));
  text += fmt::format("<text class=\"small\" x=\"36\" y=\"68\">{}</text>\n", details(report, a.dim()));
  text +=
      fmt::format("<text class=\"verdict\" x=\"{}\" y=\"68\">{}</text>\n", pixels(kTable.x), verdict(report));
  text += draw_links(a, b, match.correspondence, kLinks);
  text += draw_table(match, options, kTable);
  const double below = kTable.y + kTable.height + 32.0;
  text += legend(kTable.x, below, "stroke=\"#1d2b53\" stroke-width=\"5\" stroke-opacity=\"0.4\"", "path");
  text += legend(kTable.x + 90.0, below, "stroke=\"#e8590c\" stroke-width=\"1.8\"", "v(u)");
  text += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"22\" height=\"12\" fill=\"#e0ad9b\"/>\n"
      "<text class=\"small\" x=\"{}\" y=\"{}\">invalid</text>\n",
      pixels(kTable.x + 180.0), pixels(below - 10.0), pixels(kTable.x + 210.0), pixels(below));
  return text + "</svg>\n";
}

}  // namespace v0
}  // namespace tandem
