#include <algorithm>

#include "morph/measures.h"
#include "morph/mirror.h"
#include "morph/step_keys.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// The asymmetry of a match under a turn that takes a common axis of symmetry away.
constexpr double kLostMirror = 0.1;

}  // namespace

std::optional<SharedMirror> StepKeys::shared_mirror_of(const ContourPair& pair, const Rotation& turn) const {
  if (!pair.a || !pair.b || !pins_.empty()) return std::nullopt;
  return shared_mirror(a_.mirrors[*pair.a], b_.mirrors[*pair.b], turn.degrees());
}

bool StepKeys::has_mirror(const Turned& turned) const {
  return std::any_of(turned.pairs.begin(), turned.pairs.end(), [&](const ContourPair& pair) {
    return shared_mirror_of(pair, turned.turn).has_value();
  });
}

// In the mean over all lengths. What is symmetric about axes that the turn moves apart loses it.
void StepKeys::add_asymmetry(StepCandidate& candidate, const Turned& turned) const {
  double whole = 0.0;
  std::size_t k = 0;
  for (const ContourPair& pair : turned.pairs) {
    if (!pair.a || !pair.b) continue;
    const FoundContour& found = candidate.contours[k++];
    const double length = path_length(a_.paths[*pair.a].control_points().data()) +
                          path_length(b_.paths[*pair.b].control_points().data());
    whole += length;
    if (const auto shared = shared_mirror_of(pair, turned.turn)) {
      candidate.asymmetry += length * asymmetry(found.match->found.path.correspondence,
                                                Reflection(a_.curves[*pair.a], shared->ends[0].u),
                                                Reflection(b_.curves[*pair.b], shared->ends[0].v));
    } else if (shared_mirror_of(pair, Rotation(2))) {
      candidate.asymmetry += kLostMirror * length;
    }
  }
  if (whole > 0.0) candidate.asymmetry /= whole;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
