#include "rank/pair_cost.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "rank/programme.h"
#include "tandem/match/elastic.h"
#include "tandem/match/programme.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

StepCharges charges_of(const CompareOptions& options) {
  if (options.cost == RankCost::paper) return {};
  return {.double_diagonal = true, .charge = options.charge};
}

/// What the sum over a path is divided by: the symmetric rule's weights add up to m1 + m2 on every path.
double unit_of(const Chords& a, const Chords& b, const CompareOptions& options) {
  const auto nodes = static_cast<double>(a.lengths.size() + b.lengths.size());
  return options.cost == RankCost::paper ? 0.5 * nodes : nodes;
}

/// Recognition wants the least cost, not the least invalid match: no node is invalid.
NodeTable tangent_costs(const TangentPlanes& a, const TangentPlanes& b) {
  NodeTable table{a.size(), b.size(), std::vector<double>(a.size() * b.size(), 1.0),
                  std::vector<std::uint8_t>(a.size() * b.size())};
  for (std::size_t i = 0; i < a.size(); ++i) {
    double* row = table.cost.data() + table.index(i, 0);
    for (std::size_t c = 0; c < a.planes.size(); ++c) {
      for (std::size_t j = 0; j < b.size(); ++j) row[j] -= a.planes[c][i] * b.planes[c][j];
    }
    // Tangents rounded to float could make a cost negative.
    for (std::size_t j = 0; j < b.size(); ++j) row[j] = std::max(0.0, row[j]);
  }
  return table;
}

Samples to_samples(const Chords& chords, bool closed) {
  Samples s;
  s.cyclic = closed;
  s.parameters.resize(chords.lengths.size() + (closed ? 0 : 1));
  s.chord_lengths = chords.lengths;
  return s;
}

std::optional<Fit> fit_elastic(const Chords& a, const Chords& b, bool closed, double limit) {
  const NodeTable table = tangent_costs(a.tangents, b.tangents);
  Path path = elastic_path(to_samples(a, closed), to_samples(b, closed), table);
  if (path.nodes.empty()) path.cost = std::numeric_limits<double>::infinity();
  if (!(path.cost <= limit)) return std::nullopt;
  return Fit{path.cost, std::move(path.nodes)};
}

/// The sum of weight * y x^T.
class Covariance {
 public:
  Covariance(const Chords& a, const Chords& b)
      : a_(a.tangents), b_(b.tangents), sum_(a_.planes.size() * a_.planes.size(), 0.0) {}

  void add(int i, int j, double weight) {
    const std::size_t x = static_cast<std::size_t>(i) % a_.size();
    const std::size_t y = static_cast<std::size_t>(j) % b_.size();
    const std::size_t dim = a_.planes.size();
    for (std::size_t r = 0; r < dim; ++r) {
      for (std::size_t c = 0; c < dim; ++c) sum_[r * dim + c] += weight * b_.planes[r][y] * a_.planes[c][x];
    }
  }
  [[nodiscard]] std::vector<double> sum() && { return std::move(sum_); }

 private:
  const TangentPlanes& a_;
  const TangentPlanes& b_;
  std::vector<double> sum_;
};

}  // namespace

std::optional<Fit> fit_pair(const Chords& a, const Chords& b, bool closed, const CompareOptions& options,
                            double limit) {
  if (options.cost == RankCost::elastic) return fit_elastic(a, b, closed, limit);
  const double unit = unit_of(a, b, options);
  // A little above the limit, since division rounds; then exactly.
  constexpr double kAbove = 1.0 + 1e-12;
  std::optional<PricedPath> path =
      cheapest_path(a.tangents, b.tangents, closed, charges_of(options), limit * unit * kAbove);
  if (!path || path->sum / unit > limit) return std::nullopt;
  return Fit{path->sum / unit, std::move(path->nodes)};
}

std::vector<double> covariance(const Chords& a, const Chords& b, const CompareOptions& options,
                               const Fit& fit) {
  Covariance covariance(a, b);
  const double diagonal = options.cost == RankCost::symmetric ? 2.0 : 1.0;
  for (std::size_t k = 1; k < fit.path.size(); ++k) {
    const Node from = fit.path[k - 1];
    const Node to = fit.path[k];
    if (options.cost != RankCost::elastic) {
      covariance.add(to.i, to.j, from.i != to.i && from.j != to.j ? diagonal : 1.0);
      continue;
    }
    for (int i = from.i; i < to.i; ++i) {
      for (int j = from.j; j < to.j; ++j) {
        // An edge's chords are multiplied where the integral cuts them: near enough for a turn.
        covariance.add(i, j,
                       a.lengths[static_cast<std::size_t>(i) % a.lengths.size()] *
                           b.lengths[static_cast<std::size_t>(j) % b.lengths.size()]);
      }
    }
  }
  return std::move(covariance).sum();
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
