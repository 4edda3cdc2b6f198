#include "rank/programme.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "match/start_family.h"
#include "match/three_step_kernels.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

double node_cost(const TangentPlanes& a, const TangentPlanes& b, Node node) {
  const std::size_t i = static_cast<std::size_t>(node.i) % a.size();
  const std::size_t j = static_cast<std::size_t>(node.j) % b.size();
  double product = 0.0;
  for (std::size_t c = 0; c < a.planes.size(); ++c) product += a.planes[c][i] * b.planes[c][j];
  // Tangents rounded to float could make it negative.
  return std::max(0.0, 1.0 - product);
}

double price(const TangentPlanes& a, const TangentPlanes& b, bool closed, const StepCharges& charges,
             const std::vector<Node>& nodes) {
  const double diagonal = charges.double_diagonal ? 2.0 : 1.0;
  double sum = closed ? 0.0 : diagonal * node_cost(a, b, nodes.front());
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    const bool is_diagonal = nodes[k].i != nodes[k - 1].i && nodes[k].j != nodes[k - 1].j;
    const double cost = node_cost(a, b, nodes[k]);
    sum += is_diagonal ? diagonal * cost : cost + charges.charge;
  }
  return sum;
}

}  // namespace

std::optional<PricedPath> cheapest_path(const TangentPlanes& a, const TangentPlanes& b, bool closed,
                                        const StepCharges& charges, double limit) {
  const double heaviest = (charges.double_diagonal ? 2.0 : 1.0) + 0.5 * charges.charge;
  const FixedCosts costs = fixed_tangent_costs(a, b, closed, heaviest);
  const auto charge = static_cast<std::int32_t>(std::lround(charges.charge / costs.quantum));
  const int rows = static_cast<int>(a.size()) + (closed ? 1 : 0);
  const PathFamily<std::int32_t> family{&costs.table, rows, !closed, {charges.double_diagonal, charge}};
  TracedCost<std::int32_t> best;
  if (closed) {
    const BestStart<std::int32_t> start = StartFamily<std::int32_t>(family, 1).best({});
    // Rounding moves the sum by half a quantum for every node, weighted, and every charge.
    const double rounding = costs.quantum * static_cast<double>(a.size() + b.size());
    if (static_cast<double>(start.cost) * costs.quantum - rounding > limit) return std::nullopt;
    best = trace_path(family, start.start, {});
  } else {
    best = trace_path(family, 0, {});
  }
  PricedPath path{price(a, b, closed, charges, best.nodes), std::move(best.nodes)};
  if (path.sum > limit) return std::nullopt;
  return path;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
