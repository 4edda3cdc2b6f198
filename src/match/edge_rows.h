#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "match/edge_plan.h"
#include "match/elastic_kernels.h"
#include "match/raw_buffer.h"
#include "tandem/match/cost_table.h"
#include "tandem/match/elastic.h"
#include "tandem/match/programme.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// What a programme makes of invalid edges.
enum class Counting {
  barred,   ///< they cost infinity
  counted,  ///< their invalid length counts before the cost
};

/// Steps in the order of their preference on ties: nearest the diagonal first, then the smaller a.
[[nodiscard]] std::vector<std::size_t> tie_order(const std::vector<Step>& steps);

/// The edges of the elastic programme, row of end nodes by row of end nodes, in the layout that the kernels
/// read: column x is the node x + first_col() (modulo cols() on a loop), and a row holds stride() columns per
/// step, barred from width() on.
///
/// Rows are computed when they are asked for, from the chords (no table of all edges need exist), or read
/// from an EdgeTable. Not for several threads at once.
class EdgeRows {
 public:
  /// The chord costs must outlive the rows. plan: of these curves; nothing: to be made.
  /// @throws InvalidArgument see edge_costs()
  EdgeRows(const Samples& a, const Samples& b, const NodeTable& chords, const ElasticOptions& options,
           Aggregate aggregate, std::shared_ptr<const EdgePlan> plan = nullptr);
  explicit EdgeRows(const EdgeTable& table);

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int cols() const { return cols_; }
  [[nodiscard]] bool rows_cyclic() const { return rows_cyclic_; }
  [[nodiscard]] bool cols_cyclic() const { return cols_cyclic_; }
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  [[nodiscard]] int longest() const { return longest_; }
  /// Columns in which a path may start.
  [[nodiscard]] int first_col() const { return first_col_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int stride() const { return stride_; }

  /// Sets what the rows hold from now on: edges that cost more than `threshold` are barred.
  void hold(Counting counting, double threshold);
  [[nodiscard]] Counting counting() const { return counting_; }
  /// Keeps rows once they are computed, if that takes no more than this many bytes: several programmes are to
  /// run over them. whole: of all columns, not only of those asked for.
  void keep(std::size_t bytes, bool whole);

  struct Row {
    const double* cost;     ///< steps() * stride()
    const double* invalid;  ///< the same, infinite with the cost; nullptr where invalid edges are barred
  };
  /// Edges that end in row i, 0 <= i < rows(), at least in these columns; valid until the next call. Where
  /// rows are not cyclic, steps longer than i mean nothing.
  [[nodiscard]] Row row(int i, Columns columns);

 private:
  void plan_row(int i);
  void load_chords(int i, Columns columns);
  void load_chord_row(int row, std::size_t slot, Columns columns);
  void weigh_last_chords(Columns columns);
  void compute_row(int i, Columns columns, double* cost, double* invalid);
  void integrate(Columns columns, const std::vector<double>& chords, EdgeValue value, double* out);
  void copy_row(int i, double* cost, double* invalid);

  int rows_;
  int cols_;
  bool rows_cyclic_;
  bool cols_cyclic_;
  std::vector<Step> steps_;
  int longest_ = 1;
  int first_col_ = 1;
  int width_ = 0;
  int stride_ = 0;
  Counting counting_ = Counting::barred;
  double most_ = 0.0;  ///< the largest chord cost
  double threshold_;
  std::size_t row_size_ = 0;
  RawBuffer cost_;  ///< one row, or all; columns that nobody asked for hold anything
  RawBuffer invalid_;
  std::vector<Columns> known_;  ///< by row, where they are kept
  std::size_t kept_bytes_ = 0;
  bool whole_rows_ = false;

  const EdgeTable* table_ = nullptr;

  // Computed rows only.
  const NodeTable* chords_ = nullptr;
  Aggregate aggregate_ = Aggregate::sum;
  double lambda_ = 0.0;
  std::shared_ptr<const EdgePlan> plan_;

  // A window of chord rows slides along with the row that is asked for.
  int chord_stride_ = 0;
  std::size_t window_rows_ = 0;
  int window_row_ = -1;          ///< the row whose chords were loaded last; -1: none
  std::size_t window_slot_ = 0;  ///< slot of the row itself, behind its chords
  std::vector<double> chord_cost_;
  std::vector<double> chord_flag_;
  std::vector<std::uint8_t> flagged_;  ///< slots with any invalid chord

  // Of the row that is computed.
  const EdgePlan::RowPlan* row_plan_ = nullptr;
  std::vector<const EdgePlan::Weights*> weights_;  ///< by a
  std::vector<EdgeSum> sums_;
  // Where the plan does not keep them.
  std::vector<EdgePlan::Weights> own_weights_;  ///< by a
  std::vector<double> weighed_;                 ///< the lengths that they belong to
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
