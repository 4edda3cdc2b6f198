#include "morph/made_steps.h"

#include <utility>

#include "match/match_along.h"

namespace tandem {
inline namespace v0 {
namespace detail {

MadeStep reversed(MadeStep step, std::span<const CubicPath> seconds, const MatchOptions& options) {
  const PlanarFrame& frame = step.frame;
  step.frame =
      PlanarFrame(frame.second_center(), frame.first_center(), -frame.degrees(), 1.0 / frame.scale());
  for (std::size_t t = 0; t < step.contours.size(); ++t) {
    ContourStep& contour = step.contours[t];
    if (contour.match) {
      contour.match = inverse_match(to_curve(*step.firsts[t]), to_curve(seconds[*contour.b]), options,
                                    *std::move(contour.match));
    }
    std::swap(contour.a, contour.b);
  }
  step.firsts.clear();
  return step;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
