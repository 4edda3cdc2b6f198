#include "morph/step_candidate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "morph/measures.h"
#include "tandem/morph/align.h"

namespace tandem {
inline namespace v0 {
namespace detail {

std::vector<ContourEnds> StepCandidate::ends() const {
  std::vector<ContourEnds> all;
  all.reserve(contours.size());
  for (const FoundContour& contour : contours) all.push_back(contour.ends);
  return all;
}

StepBlend StepCandidate::blend(BlendKind kind) const {
  StepBlend made(kind, frame, ends());
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const FoundContour& contour = contours[c];
    if (!contour.detour.is_none()) made.set_detour(c, contour.detour);
    if (contour.outline_a || contour.outline_b) made.set_outlines(c, contour.drawn());
  }
  return made;
}

StepCandidate subdivided(StepCandidate candidate, double longest) {
  for (FoundContour& contour : candidate.contours) {
    const double length_a = path_length(contour.ends.a.control_points().data());
    const double length_b = path_length(contour.ends.b.control_points().data());
    const auto share = [](const CubicPath& path, std::size_t segment, double whole) {
      return whole > 0.0 ? path_length(path.control_points().data().subspan(6 * segment, 8)) / whole : 0.0;
    };
    // In the parameters of the aligned paths, and of the first key's own.
    std::vector<double> cuts{0.0};
    std::vector<double> own{contour.cuts.empty() ? 0.0 : contour.cuts.front()};
    for (std::size_t k = 0; k < contour.ends.a.segment_count(); ++k) {
      const double parts = std::max(
          1.0, std::ceil(std::max(share(contour.ends.a, k, length_a), share(contour.ends.b, k, length_b)) /
                         longest));
      const double from = own.back();
      const double to = contour.cuts.empty() ? from + 1.0 : contour.cuts[k + 1];
      for (double p = 1.0; p <= parts; p += 1.0) {
        cuts.push_back(static_cast<double>(k) + p / parts);
        own.push_back(p == parts ? to : from + (to - from) * p / parts);
      }
    }
    for (CubicPath* path : {&contour.ends.a, &contour.ends.b}) *path = cut_at(*path, cuts, path->is_closed());
    for (auto* outline : {&contour.outline_a, &contour.outline_b}) {
      if (*outline) *outline = cut_at(**outline, cuts, (*outline)->is_closed());
    }
    if (contour.a) contour.cuts = std::move(own);
  }
  return candidate;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
