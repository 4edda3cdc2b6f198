#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "match/band.h"
#include "match/edge_rows.h"
#include "match/lexicographic.h"
#include "tandem/match/programme.h"
#include "tandem/progress.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Where a run begins, and what its paths have cost before.
struct ProgrammeStart {
  int number = 0;
  LexCost value{0.0, 0.0};
};

/// One programme over the unrolled grid, from many starts at once.
///
/// Starts are numbered by row, then by column: a closed path starts in one of the first first_col() columns,
/// and no path is led through these, so that every closed path is counted once, at the last of its nodes that
/// lies there; other paths start in column 0. Only costs are kept. Where a path comes from is found
/// afterwards, by looking which edge attains the cost: each candidate is one sum, so that equality is exact.
class ElasticProgramme {
 public:
  /// The rows and the band (if any) must outlive the programme.
  ElasticProgramme(EdgeRows& edges, Aggregate aggregate, const Band* band);

  /// Rows in which a path may start, times starts in a row.
  [[nodiscard]] int start_count() const { return start_rows_ * edges_.first_col(); }

  /// Runs the programme from these starts, in rising order. keep_going gets the share done, now and then;
  /// false: it said no.
  [[nodiscard]] bool run(std::span<const ProgrammeStart> starts, const Progress& keep_going = {});

  /// Of the last run: the cost of the best path from any start to the end that belongs to this one.
  [[nodiscard]] LexCost end_cost(int start) const;
  /// The start from which that path comes; the end must have been reached.
  [[nodiscard]] int origin(int start);
  /// That path, with its own cost.
  [[nodiscard]] Path path(int start);

 private:
  struct Cell {
    int i;  ///< row of the run
    int x;  ///< column as in EdgeRows; < 0: a start
  };

  struct Edge {
    Cell from;
    LexCost cost;
  };

  [[nodiscard]] std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.i) * cell_stride_ + static_cast<std::size_t>(pad_ + c.x);
  }
  [[nodiscard]] Cell end_of(int start) const;
  [[nodiscard]] int start_at(Cell c) const;
  [[nodiscard]] int table_row(int i) const;
  [[nodiscard]] Columns reachable(int i, int start_rows) const;
  void relax_row(int i, Columns columns);
  [[nodiscard]] Edge edge_to(Cell c);

  EdgeRows& edges_;
  bool maximum_;
  const Band* band_;
  std::vector<std::size_t> order_;  ///< of the steps on ties
  int start_rows_;
  int base_row_;  ///< of start 0
  int descent_;   ///< rows from the start of a path to its end
  int pad_;
  std::size_t cell_stride_;

  int first_row_ = 0;  ///< of the last run, above base_row_
  std::vector<double> cost_;
  std::vector<double> invalid_;
  std::vector<RelaxStep> relax_;
  std::vector<std::int32_t> origin_;  ///< start + 1 of the cells that were traced in the last run; 0: not yet
};

/// The optimal path over all starts: first with invalid edges barred, and only if there is none, in the
/// lexicographic order. Exact: branch and bound (within the band, if any). beat: see closed_path().
[[nodiscard]] Path best_elastic_path(EdgeRows& edges, Aggregate aggregate, const Band* band,
                                     const Progress& progress, const Path* beat);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
