#include "frames.h"

#include <fmt/format.h>

#include "report.h"
#include "tandem/io/json.h"
#include "tandem/io/path_data.h"

namespace cli {
std::string format_frames(std::span<const double> positions, const std::string& reports,
                          const std::function<std::string(double s)>& content) {
  std::string text = "{\"frames\": [";
  for (std::size_t i = 0; i < positions.size(); ++i) {
    text += i == 0 ? "\n  {\"s\": " : ",\n  {\"s\": ";
    text += json_number(positions[i]);
    text += ", ";
    text += content(positions[i]);
    text += '}';
  }
  text += "],\n ";
  text += reports;
  text += "}\n";
  return text;
}

std::string format_path_frames(const tandem::PathMorph& morph, std::span<const double> positions,
                               const std::string& reports, int precision) {
  return format_frames(positions, reports, [&](double s) {
    return "\"d\": \"" + tandem::format_path_data(morph, s, precision) + '"';
  });
}

std::string format_curve_frames(const tandem::Morph& morph, std::span<const double> positions,
                                const std::string& reports) {
  return format_frames(positions, reports, [&](double s) {
    const tandem::Shape shape = morph.at(s);
    std::string text = "\"curves\": [";
    for (std::size_t i = 0; i < shape.contours.size(); ++i) {
      if (i != 0) text += ", ";
      text += trimmed(tandem::format_json_curves({&shape.contours[i], 1}));
    }
    return text + ']';
  });
}

}  // namespace cli
