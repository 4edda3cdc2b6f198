#pragma once

#include <functional>
#include <span>
#include <string>

#include "tandem/morph/morph.h"
#include "tandem/morph/path_morph.h"

namespace cli {

/// {"frames": [{"s": 0.5, CONTENT}, ...], REPORTS}. content(s): members of the frame's object.
[[nodiscard]] std::string format_frames(std::span<const double> positions, const std::string& reports,
                                        const std::function<std::string(double s)>& content);

/// {"frames": [{"s": 0.5, "d": "M0 0C..."}, ...], REPORTS}: planar in-betweens as path data; precision as
/// there.
[[nodiscard]] std::string format_path_frames(const tandem::PathMorph& morph,
                                             std::span<const double> positions, const std::string& reports,
                                             int precision);

/// {"frames": [{"s": 0.5, "curves": [...]}, ...], REPORTS}: in-betweens of any dimension as JSON curves.
[[nodiscard]] std::string format_curve_frames(const tandem::Morph& morph, std::span<const double> positions,
                                              const std::string& reports);

}  // namespace cli
