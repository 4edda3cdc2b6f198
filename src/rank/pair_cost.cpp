#include "rank/pair_cost.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "match/vector.h"
#include "tandem/match/elastic.h"
#include "tandem/match/programme.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

StepRule rule_of(const CompareOptions& options) {
  if (options.cost == RankCost::paper) return {};
  return {.diagonal_weight = 2.0, .charge = options.charge};
}

/// What the sum over a path is divided by: the symmetric rule's weights add up to m1 + m2 on every path.
double unit_of(const Chords& a, const Chords& b, const CompareOptions& options) {
  const auto nodes = static_cast<double>(a.lengths.size() + b.lengths.size());
  return options.cost == RankCost::paper ? 0.5 * nodes : nodes;
}

/// 1 - <T1,T2>; tangents rounded to float could make it negative.
CostTable tangent_costs(const Points& a, const Points& b) {
  CostTable table{a.size(), b.size(), std::vector<double>(a.size() * b.size())};
  double* cost = table.cost.data();
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) *cost++ = std::max(0.0, 1.0 - dot(a[i], b[j]));
  }
  return table;
}

Samples to_samples(const Chords& chords, bool closed) {
  Samples s;
  s.cyclic = closed;
  s.parameters.resize(chords.lengths.size() + (closed ? 0 : 1));
  s.chord_tangents = chords.tangents;
  s.chord_lengths = chords.lengths;
  return s;
}

std::optional<Fit> fit_elastic(const Chords& a, const Chords& b, bool closed, double limit) {
  const CostTable costs = tangent_costs(a.tangents, b.tangents);
  // Recognition wants the least cost, not the least invalid match: no node is invalid.
  const NodeTable table{costs.rows, costs.cols, costs.cost, std::vector<std::uint8_t>(costs.cost.size())};
  const EdgeTable edges = edge_costs(to_samples(a, closed), to_samples(b, closed), table);
  Path path = closed ? closed_path(edges) : open_path(edges);
  // Numbers of nodes that differ by more than the longest step: no path at all.
  if (path.nodes.empty()) path.cost = std::numeric_limits<double>::infinity();
  if (!(path.cost <= limit)) return std::nullopt;
  const int shift = path.nodes.empty() ? 0 : path.nodes.front().i;
  return Fit{path.cost, shift, std::move(path.nodes)};
}

}  // namespace

std::optional<Fit> fit_pair(const Chords& a, const Chords& b, bool closed, const CompareOptions& options,
                            double limit) {
  if (options.cost == RankCost::elastic) return fit_elastic(a, b, closed, limit);
  const double unit = unit_of(a, b, options);
  const Optimum best = optimum(tangent_costs(a.tangents, b.tangents), closed, rule_of(options), limit * unit);
  if (best.start < 0 || !(best.sum / unit <= limit)) return std::nullopt;
  return Fit{best.sum / unit, best.start, {}};
}

std::vector<double> covariance(const Chords& a, const Chords& b, bool closed, const CompareOptions& options,
                               const Fit& fit) {
  const auto dim = static_cast<std::size_t>(a.tangents.dim());
  std::vector<double> sum(dim * dim, 0.0);
  const std::size_t m1 = a.lengths.size();
  const std::size_t m2 = b.lengths.size();
  const auto add = [&](std::size_t i, std::size_t j, double weight) {
    const auto x = a.tangents[i % m1];
    const auto y = b.tangents[j % m2];
    for (std::size_t r = 0; r < dim; ++r) {
      for (std::size_t c = 0; c < dim; ++c) sum[r * dim + c] += weight * y[r] * x[c];
    }
  };
  if (options.cost == RankCost::elastic) {
    for (std::size_t k = 1; k < fit.path.size(); ++k) {
      const Node from = fit.path[k - 1];
      const Node to = fit.path[k];
      for (int i = from.i; i < to.i; ++i) {
        for (int j = from.j; j < to.j; ++j) {
          const auto row = static_cast<std::size_t>(i) % m1;
          const auto column = static_cast<std::size_t>(j) % m2;
          // Lengths of an edge's chords multiply where the integral would cut them: near enough for a turn.
          add(row, column, a.lengths[row] * b.lengths[column]);
        }
      }
    }
    return sum;
  }
  const StepRule rule = rule_of(options);
  const std::vector<Node> path = trace(tangent_costs(a.tangents, b.tangents), closed, rule, fit.shift);
  for (std::size_t k = 0; k < path.size(); ++k) {
    if (k == 0 && closed) continue;
    const bool diagonal = k == 0 || (path[k].i != path[k - 1].i && path[k].j != path[k - 1].j);
    add(static_cast<std::size_t>(path[k].i), static_cast<std::size_t>(path[k].j),
        diagonal ? rule.diagonal_weight : 1.0);
  }
  return sum;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
