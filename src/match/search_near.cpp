#include "match/search_near.h"

#include <utility>
#include <vector>

#include "match/band.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Coarse to fine: the fine programme may stray from the coarse one by three coarse samples.
constexpr int kBandRadius = 3 * kCoarsening;

}  // namespace

SearchResult search_near(const SamplePair& coarse, const SamplePair& fine, MatchOptions options,
                         Layout layout, EdgePlans* plans) {
  if (!options.pins.empty()) return search(fine.a, fine.b, options, layout);
  SearchResult found = search(coarse.a, coarse.b, options, layout, nullptr, plans);
  if (found.path.cancelled) return found;
  if (!found.path.nodes.empty()) {
    options.direction = found.reversed ? Direction::reversed : Direction::forward;
    const Samples fine_b = found.reversed ? reversed(fine.b) : fine.b;
    std::vector<Node> path = found.path.nodes;
    const bool transposed = is_transposed(layout, options.method);
    if (transposed) {
      for (Node& node : path) std::swap(node.i, node.j);
    }
    const Band band = transposed ? band_near({fine_b, fine.a}, {found.samples_b, coarse.a}, path, kBandRadius,
                                             options.elastic.longest_step)
                                 : band_near({fine.a, fine_b}, {coarse.a, found.samples_b}, path, kBandRadius,
                                             options.elastic.longest_step);
    SearchResult near = search(fine.a, fine.b, options, layout, &band, plans);
    if (!near.path.nodes.empty() || near.path.cancelled) return near;
  }
  return search(fine.a, fine.b, options, layout, nullptr, plans);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
