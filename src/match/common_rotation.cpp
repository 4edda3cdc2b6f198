#include <cstddef>
#include <string>
#include <vector>

#include "match/find_rotation.h"
#include "tandem/error.h"
#include "tandem/match/rotation.h"

namespace tandem {
inline namespace v0 {

Rotation common_rotation(std::span<const Curve> a, std::span<const Curve> b, const MatchOptions& given,
                         double least_gain) {
  MatchOptions options = given;
  if (options.method == Method::segments) options.method = Method::elastic;
  options.pins.clear();  // of one pair, not of all
  if (a.empty() || a.size() != b.size()) {
    throw InvalidArgument("a common rotation needs pairs of curves; there are " + std::to_string(a.size()) +
                          " and " + std::to_string(b.size()));
  }
  detail::check_turnable(options.norm);
  std::vector<detail::RotationTask> tasks;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k].dim() != a[0].dim() || b[k].dim() != a[0].dim()) {
      throw InvalidArgument("the curves of pair " + std::to_string(k) + " have dimensions " +
                            std::to_string(a[k].dim()) + " and " + std::to_string(b[k].dim()) +
                            ", expected " + std::to_string(a[0].dim()));
    }
    const detail::Layout layout = detail::choose_layout(a[k], b[k], options.closed);
    tasks.push_back({detail::sample_pair(a[k], b[k], options, layout, 1),
                     detail::sample_pair(a[k], b[k], options, layout, detail::kCoarsening), layout});
  }
  return detail::find_rotation(tasks, options, least_gain).rotation;
}

}  // namespace v0
}  // namespace tandem
