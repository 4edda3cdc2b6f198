#include "match/segment_arcs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "match/segment_cost.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// A cost that is no smaller than this share of the two energies that it is the difference of is right to
/// some twelve digits; smaller ones are summed up piece by piece.
constexpr double kTrusted = 1e-3;

/// Room for rounding where a bound sorts out arcs.
constexpr double kSlack = 1.0 + 1e-9;

double paper_energy(const SegmentVectors& path, std::size_t i) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    for (double c : path.vector(i, k)) sum += c * c;
  }
  return sum;
}

}  // namespace

SegmentArcs::SegmentArcs(const SegmentVectors& rows, const SegmentVectors& cols, SegmentCost cost)
    : rows_(rows),
      cols_(cols),
      cost_(cost),
      row_singles_(singles(rows, cost)),
      col_singles_(singles(cols, cost)) {}

SegmentArcs::Singles SegmentArcs::singles(const SegmentVectors& path, SegmentCost cost) {
  Singles result;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto e0 = path.vector(i, 0);
    const auto e1 = path.vector(i, 1);
    const auto e2 = path.vector(i, 2);
    for (std::size_t d = 0; d < path.dim; ++d) result.powers.push_back(3.0 * e0[d]);
    for (std::size_t d = 0; d < path.dim; ++d) result.powers.push_back(6.0 * (e1[d] - e0[d]));
    for (std::size_t d = 0; d < path.dim; ++d) {
      result.powers.push_back(3.0 * (e0[d] - 2.0 * e1[d] + e2[d]));
    }
    if (cost == SegmentCost::derivative) {
      result.energies.push_back(
          derivative_energy(std::span(path.vectors).subspan(3 * path.dim * i, 3 * path.dim), path.dim));
      continue;
    }
    // The control differences of a piece are h times a mean of the segment's, and the h of all pieces sum to
    // 1: the sum of squares of all of them is 3 times the largest square at most.
    double most = 0.0;
    for (const auto& e : {e0, e1, e2}) {
      double square = 0.0;
      for (double c : e) square += c * c;
      most = std::max(most, square);
    }
    result.energies.push_back(3.0 * most);
  }
  return result;
}

double SegmentArcs::cost_of(const SegmentVectors& one, const Singles& single, std::size_t i,
                            const SegmentVectors& run, const SegmentRuns& runs, std::size_t first,
                            std::size_t count, double most) const {
  if (cost_ == SegmentCost::derivative && count > 1) {
    const SegmentRuns::Run r = runs.run(first, count);
    const double* powers = single.powers.data() + 3 * one.dim * i;
    double product = 0.0;
    for (std::size_t k = 0; k < 3 * one.dim; ++k) product += powers[k] * r.moments[k];
    const double energy = single.energies[i] + r.energy;
    const double cost = energy - 2.0 * product;
    if (cost > kTrusted * energy) return cost;
  }
  return cost_by_pieces(one, i, run, first, count, cost_, most);
}

void SegmentArcs::add_runs(const SegmentVectors& one, const Singles& single, std::size_t i,
                           const SegmentVectors& run, const SegmentRuns& runs, std::size_t first,
                           bool one_is_row, std::size_t longest, double most) {
  // |x - y| >= |x| - |y| in the norms whose squares the costs are, and a run's norm grows with its length.
  const double reach = (std::sqrt(single.energies[i]) + std::sqrt(most)) * kSlack;
  double paper = 0.0;
  for (std::size_t count = 1; count <= longest && (run.closed || first + count <= run.size()); ++count) {
    if (cost_ == SegmentCost::paper) paper += paper_energy(run, first + count - 1);
    const double energy = cost_ == SegmentCost::paper ? paper : runs.run(first, count).energy;
    if (std::sqrt(energy) > reach) break;
    if (count == 1 && !one_is_row) continue;  // the same as from the other side
    const double cost = cost_of(one, single, i, run, runs, first, count, most);
    if (!(cost <= most)) continue;
    const auto k = static_cast<std::int32_t>(count);
    arcs_.push_back(one_is_row ? SegmentArc{1, k, cost} : SegmentArc{k, 1, cost});
  }
}

void SegmentArcs::list(std::size_t longest, double most) {
  arcs_.clear();
  starts_.assign(1, 0);
  const std::size_t longest_rows = std::min(longest, rows_.size());
  const std::size_t longest_cols = std::min(longest, cols_.size());
  const SegmentRuns row_runs(rows_, cost_ == SegmentCost::paper ? 0 : longest_rows);
  const SegmentRuns col_runs(cols_, cost_ == SegmentCost::paper ? 0 : longest_cols);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    for (std::size_t j = 0; j < cols_.size(); ++j) {
      add_runs(rows_, row_singles_, i, cols_, col_runs, j, true, longest_cols, most);
      add_runs(cols_, col_singles_, j, rows_, row_runs, i, false, longest_rows, most);
      starts_.push_back(arcs_.size());
    }
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
