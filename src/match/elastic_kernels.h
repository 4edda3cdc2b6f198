#pragma once

#include <cstddef>

namespace tandem {
inline namespace v0 {
namespace detail {

/// Columns are worked on in blocks of this many doubles, whatever the width of the machine's vectors, so that
/// every instruction set computes the same cells. Ranges of columns below are whole blocks.
inline constexpr int kBlock = 8;

/// What an edge holds: a sum of weighted chord costs made a cost; the largest chord cost; or the weighted
/// share of invalid chords made an invalid length.
enum class EdgeValue { integral, largest, invalid };

/// One addend of an edge's integral: chord costs at a fixed offset from the edge's end node.
struct EdgeTerm {
  std::ptrdiff_t offset;
  double weight;
};

/// The edges of one step that end in a row: terms [first, last) added up (after those of the sum before, if
/// this one continues it), times `factor`, plus lambda times `strain`.
struct EdgeSum {
  bool continues;
  std::size_t first;
  std::size_t last;
  const double* factor;  ///< by column, as the others
  const double* strain;
  double* out;
};

/// Shares of an edge below this are rounding: a cell so small is none.
inline constexpr double kSliver = 1e-12;

/// Invalid length is counted in this many units per unit of length; what is invalid at all counts one.
struct EdgeOptions {
  EdgeValue value;
  double units;
  double lambda;  ///< of the strain
};

/// Writes sums[k].out[lo..hi). chords: the costs under the row's end nodes; terms index it.
void integrate_edges(const double* chords, const EdgeTerm* terms, const EdgeSum* sums, std::size_t count,
                     std::size_t lo, std::size_t hi, const EdgeOptions& options);

/// The edges of one step (a,b) where chords of different length meet: the cells are where stretches of both
/// curves overlap, and differ from column to column.
struct EdgeOverlaps {
  int a;
  int b;
  std::ptrdiff_t row_stride;    ///< from a row of chords to the next
  const double* ends_a;         ///< a + 1 shares of the edge at which chords of the first curve meet
  const double* const* ends_b;  ///< b + 1 arrays of them, by column
  const double* spread_b;       ///< by block of columns: the least and the largest of each of the b + 1
  const double* factor;
  const double* strain;
  double* out;
};
void integrate_overlaps(const double* chords, const EdgeOverlaps& edges, std::size_t lo, std::size_t hi,
                        const EdgeOptions& options);

/// One step as the relaxation reads it: everything by the column of the end node.
struct RelaxStep {
  const double* from_cost;
  const double* edge_cost;
  const double* from_invalid;
  const double* edge_invalid;
};

/// to[lo..hi) becomes the least from + edge, or max(from, edge), over all steps.
void relax_costs(const RelaxStep* steps, std::size_t count, double* to, std::size_t lo, std::size_t hi,
                 bool maximum);

/// The same in the order (invalid, cost). What is barred must have an infinite invalid length.
void relax_pairs(const RelaxStep* steps, std::size_t count, double* to_cost, double* to_invalid,
                 std::size_t lo, std::size_t hi, bool maximum);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
