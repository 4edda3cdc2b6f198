#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tandem/match/cost_table.h"
#include "tandem/progress.h"
#include "tandem/tandem_export.h"

/// The dynamic programmes. They see cost tables, never curves or norms (docs/architecture.md, decision 5).
///
/// All orders are lexicographic: first the least invalidity, then the least cost (spec C5). Costs are >= 0;
/// an infinite one bars the node or edge. A path without nodes means: there is none.
/// @throws InvalidArgument (all of them) a table whose sizes disagree, or a cost that is negative or not a
/// number
namespace tandem {
inline namespace v0 {

/// How the costs along a path add up.
enum class Aggregate {
  sum,
  maximum,  ///< the largest cost of the path; among the paths that attain its minimum, the least sum
};

/// An optimal path. `cost` is without any penalty for invalid nodes.
struct Path {
  std::vector<Node> nodes;
  double cost = 0.0;
  std::int64_t invalid =
      0;  ///< invalid nodes (three steps); invalid length in units of kInvalidQuantum (elastic)
  std::vector<std::uint8_t> invalid_nodes;  ///< three steps: one flag per node
  bool cancelled = false;                   ///< the progress callback said stop; the rest is meaningless
};

// --- three steps: (1,1), (0,1), (1,0), costs at nodes; [C] eq. (7) ---

/// Optimal path (0,0) -> (rows-1, cols-1). Ties: diagonal first, then (i, j-1), then (i-1, j). Needs two bits
/// per node beside the table.
[[nodiscard]] TANDEM_EXPORT Path open_path(const NodeTable& table, Aggregate aggregate = Aggregate::sum);

/// The table Cost(i,j) of [C] eq. (7), rows * cols, with `penalty` for an invalid node in place of its cost
/// ([C]: 2m, here rows + cols): for figures and comparison.
[[nodiscard]] TANDEM_EXPORT std::vector<double> accumulated_costs(const NodeTable& table);

/// Optimal closed path over all starts k: (k,0) -> (k + rows, cols) on the doubled grid, the start node
/// counted once (toroidal form: Fuchs, Kedem, Uselton 1977; spec C10). The first node has 0 <= i < rows, j =
/// 0; the last is first + (rows, cols). Exact, in O(m^2 log m). threads: 0: all; the result does not depend
/// on them.
[[nodiscard]] TANDEM_EXPORT Path closed_path(const NodeTable& table, Aggregate aggregate = Aggregate::sum,
                                             const Progress& progress = {}, int threads = 1);

/// The paper's form for closed curves: for every cyclic shift k of the columns the open programme with both
/// ends pinned, (0,k) -> (rows-1, k + cols-1); the best of all shifts, the smallest on a tie.
[[nodiscard]] TANDEM_EXPORT Path pinned_path(const NodeTable& table, Aggregate aggregate = Aggregate::sum,
                                             const Progress& progress = {}, int threads = 1);

/// The rows' loop cut where it fits the open columns best: the optimal path (k,0) -> (k + rows, cols-1) over
/// all k, both ends counted.
[[nodiscard]] TANDEM_EXPORT Path cut_path(const NodeTable& table, Aggregate aggregate = Aggregate::sum,
                                          const Progress& progress = {}, int threads = 1);

// --- elastic: steps (a,b), costs at edges ---

/// Unit in which the elastic programme counts invalid length, as a share of the (normalised) length. Whole
/// units make the lexicographic order independent of rounding.
inline constexpr double kInvalidQuantum = 1.0 / 4294967296.0;

/// The steps (a,b) with 1 <= a,b <= longest and gcd(a,b) = 1, by a, then b.
[[nodiscard]] TANDEM_EXPORT std::vector<Step> coprime_steps(int longest = 6);

/// Costs of all edges (i-a, j-b) -> (i,j), by row of the end node, then by step, then by column.
///
/// A cyclic direction takes indices modulo its size; in the others edges that would start outside are barred.
struct EdgeTable {
  std::size_t rows = 0;
  std::size_t cols = 0;
  bool rows_cyclic = false;
  bool cols_cyclic = false;
  std::vector<Step> steps;
  std::vector<double> cost;     ///< rows * steps * cols
  std::vector<double> invalid;  ///< whole multiples of kInvalidQuantum, counted in it (exact in a double)

  [[nodiscard]] std::size_t index(std::size_t i, std::size_t step, std::size_t j) const noexcept {
    return (i * steps.size() + step) * cols + j;
  }
};

/// Optimal path (0,0) -> (rows-1, cols-1) of a table that is cyclic in no direction.
/// Ties: the step nearest the diagonal first, then the smaller a.
[[nodiscard]] TANDEM_EXPORT Path open_path(const EdgeTable& table, Aggregate aggregate = Aggregate::sum);

/// Optimal closed path of a table that is cyclic in both directions, over all starts (k,l), 0 <= k < rows,
/// 0 <= l < longest step (a path may jump over column 0; spec C10). Exact: potentials, and branch and bound,
/// over the starts (paths that differ by less than 1e-13 of their cost are as good). beat: a path of another
/// table to be beaten; none comes back once it is certain that all are worse (a tie within 1e-9 is still
/// found).
[[nodiscard]] TANDEM_EXPORT Path closed_path(const EdgeTable& table, Aggregate aggregate = Aggregate::sum,
                                             const Progress& progress = {}, const Path* beat = nullptr);

/// The rows' loop cut where it fits the open columns best: the optimal path (k,0) -> (k + rows, cols-1) over
/// all k, of a table that is cyclic in its rows only. Exact, likewise.
[[nodiscard]] TANDEM_EXPORT Path cut_path(const EdgeTable& table, Aggregate aggregate = Aggregate::sum,
                                          const Progress& progress = {}, const Path* beat = nullptr);

}  // namespace v0
}  // namespace tandem
