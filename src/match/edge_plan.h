#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "match/elastic_kernels.h"
#include "tandem/match/elastic.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A whole number of blocks of columns.
struct Columns {
  int lo = 0;
  int hi = 0;
};

[[nodiscard]] constexpr int whole_blocks(int n) noexcept {
  return (n + kBlock - 1) / kBlock * kBlock;
}

/// What the edges of two sampled curves have in common whatever their chords cost, in whatever norm and under
/// whatever turn: how the lengths of their chords lie beside each other. Laid out as EdgeRows.
class EdgePlan {
 public:
  /// Arrays by column that one curve's chords give for runs of n of them.
  struct Runs {
    std::vector<double> length;             ///< of the n chords before each node
    std::vector<std::vector<double>> ends;  ///< n + 1 arrays: shares of it at which the chords meet
    std::vector<const double*> end_arrays;  ///< the same
    std::vector<double> spread;             ///< by block: least and largest share, for every array
    std::vector<Columns> mixed;             ///< blocks with chords of different length
    std::vector<Columns> plain;             ///< the others
  };

  /// The chords that the edges of one step add up: terms [first, last), after those of the step before if
  /// `continues`.
  struct StepTerms {
    std::size_t step;
    bool continues;
    std::size_t first;
    std::size_t last;
  };

  /// What depends on the lengths of the chords before a row.
  struct RowPlan {
    std::vector<double> chords;             ///< those lengths
    std::vector<double> lengths;            ///< by a: of the last a of them
    std::vector<std::vector<double>> ends;  ///< by a: a + 1 shares of that length at which the chords meet
    std::vector<EdgeTerm> terms;
    std::vector<StepTerms> sums;  ///< first those with a = 1 or b = 1, then the others by b
    std::vector<std::size_t>
        weights;  ///< by a: which of the kept weights are these; none where none are kept
  };

  /// Of all steps (a,b) for one a, by step, then by column: factors that make integrals costs, and strains
  /// before lambda. The integrals of (1,b) and (a,1) are not divided by the run's length yet.
  struct Weights {
    std::vector<double> factor;
    std::vector<double> strain;
  };

  /// @throws InvalidArgument longest_step < 1
  EdgePlan(const Samples& a, const Samples& b, int longest_step);
  EdgePlan(const EdgePlan&) = delete;
  EdgePlan& operator=(const EdgePlan&) = delete;

  /// Whether it is the plan of these curves.
  [[nodiscard]] bool is_of(const Samples& a, const Samples& b, int longest_step) const;

  [[nodiscard]] int longest() const { return longest_; }
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  /// The first step (a,b) of an a, and the first one behind.
  [[nodiscard]] std::size_t first_step(int a) const { return first_steps_[static_cast<std::size_t>(a)]; }
  /// Steps with a = 1 or b = 1.
  [[nodiscard]] std::size_t straight_steps() const { return 2 * static_cast<std::size_t>(longest_) - 1; }
  /// Columns in which a path may start.
  [[nodiscard]] int first_col() const { return first_col_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int stride() const { return stride_; }
  [[nodiscard]] int chord_stride() const { return chord_stride_; }

  [[nodiscard]] const Runs& runs(int b) const { return runs_b_[static_cast<std::size_t>(b)]; }
  /// Lengths of the chords before each column, from whole_blocks(longest()) before column 0 on.
  [[nodiscard]] const std::vector<double>& chord_lengths() const { return chord_b_; }
  [[nodiscard]] const RowPlan& row(int i) const { return rows_[row_of_[static_cast<std::size_t>(i)]]; }

  /// Whether the weights of all rows are kept: there are not too many.
  [[nodiscard]] bool keeps_weights() const { return keeps_weights_; }
  [[nodiscard]] const Weights& kept_weights(const RowPlan& row, int a) const {
    return weights_[row.weights[static_cast<std::size_t>(a)]];
  }
  void weigh(int a, double length_a, Weights& weights) const;

 private:
  void measure_columns();
  void mark_mixed(Runs& runs, int n);
  [[nodiscard]] RowPlan plan_row(std::span<const double> chords) const;
  void add_terms(RowPlan& plan) const;
  void keep_weights();

  std::array<std::vector<double>, 2> given_lengths_;
  std::array<bool, 2> cyclic_;
  int longest_step_;
  int longest_;
  std::vector<Step> steps_;
  std::vector<std::size_t> first_steps_;
  int first_col_ = 1;
  int width_ = 0;
  int stride_ = 0;
  int chord_stride_ = 0;
  std::vector<Runs> runs_b_;     ///< by number of chords
  std::vector<double> chord_b_;  ///< length of the chord before each column
  std::vector<RowPlan> rows_;    ///< each once
  std::vector<std::size_t> row_of_;
  bool keeps_weights_ = false;
  std::vector<Weights> weights_;
};

/// The plans of a few pairs of sampled curves, for all who match them. For several threads at once.
class EdgePlans {
 public:
  [[nodiscard]] std::shared_ptr<const EdgePlan> find(const Samples& a, const Samples& b, int longest_step);

 private:
  std::mutex mutex_;
  std::vector<std::shared_ptr<const EdgePlan>> plans_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
