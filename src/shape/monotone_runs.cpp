#include "shape/monotone_runs.h"

#include <algorithm>

namespace tandem {
inline namespace v0 {
namespace {

// Longer runs are fewer, but their boxes meet more often: of 4, 8, 16 and 32 the fastest on icons.
constexpr std::size_t kMostEdges = 8;

}  // namespace

void gather_runs(std::span<const FlatVertex> v, std::vector<MonotoneRun>& runs) {
  runs.clear();
  const std::size_t edges = v.size() - 1;
  for (std::size_t first = 0; first < edges;) {
    const bool left = v[first + 1].x < v[first].x;
    const bool down = v[first + 1].y < v[first].y;
    std::size_t last = first + 1;
    const std::size_t end = std::min(edges, first + kMostEdges);
    while (last < end && (v[last + 1].x < v[last].x) == left && (v[last + 1].y < v[last].y) == down) ++last;
    runs.push_back({std::min(v[first].x, v[last].x), std::max(v[first].x, v[last].x),
                    std::min(v[first].y, v[last].y), std::max(v[first].y, v[last].y), first, last});
    first = last;
  }
  std::sort(runs.begin(), runs.end(),
            [](const MonotoneRun& a, const MonotoneRun& b) { return a.lo_x < b.lo_x; });
}

}  // namespace v0
}  // namespace tandem
