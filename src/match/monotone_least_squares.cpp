#include "match/monotone_least_squares.h"

#include <algorithm>
#include <cmath>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// An increment this near to its bound, relative to it, lies on it.
constexpr double kOnBound = 1e-9;
/// Forces below this share of N's trace are rounding: N's rows are sums of as many products as there are
/// data.
constexpr double kNoForce = 1e-13;

enum class Bound : signed char { none, lower, upper };

class ActiveSet {
 public:
  ActiveSet(const MonotoneProblem& problem, std::vector<double> start)
      : problem_(problem),
        n_(problem.size()),
        width_(problem.bandwidth),
        current_(std::move(start)),
        bounds_(n_ - 1, Bound::none),
        block_(n_),
        target_(n_),
        multipliers_(n_ - 1),
        band_(n_ * (width_ + 1)),
        unknowns_(n_) {
    double trace = 0.0;
    for (std::size_t i = 0; i < n_; ++i) trace += problem.at(i, 0);
    no_force_ = kNoForce * trace;
  }

  MonotoneSolution run() {
    MonotoneSolution solution;
    hold_increments_on_bounds();
    const int most_solves = 50 + 10 * static_cast<int>(n_);
    while (solution.solves < most_solves) {
      solve_with_bounds_held();
      ++solution.solves;
      if (move_towards_target()) continue;
      find_multipliers();
      if (!release_one()) {
        solution.optimal = true;
        break;
      }
    }
    solution.coefficients = std::move(current_);
    solution.multipliers = std::move(multipliers_);
    return solution;
  }

  std::vector<double> unbounded() {
    solve_with_bounds_held();
    return std::move(target_);
  }

 private:
  [[nodiscard]] double slack(std::size_t i) const { return kOnBound * problem_.lower[i]; }

  void hold_increments_on_bounds() {
    for (std::size_t i = 0; i + 1 < n_; ++i) {
      const double increment = current_[i + 1] - current_[i];
      if (increment <= problem_.lower[i] + slack(i)) {
        bounds_[i] = Bound::lower;
      } else if (increment >= problem_.upper[i] - slack(i)) {
        bounds_[i] = Bound::upper;
      }
    }
    // One increment must be free to make up the sum.
    if (std::find(bounds_.begin(), bounds_.end(), Bound::none) == bounds_.end()) {
      std::fill(bounds_.begin(), bounds_.end(), Bound::none);
    }
  }

  /// Numbers the blocks, the one that holds c[0] first, and sets target_ to each coefficient's offset in its
  /// block (to its value in the first and last block, whose ends are given). Returns the number of blocks.
  std::size_t make_blocks() {
    std::size_t blocks = 0;
    block_[0] = 0;
    target_[0] = problem_.first;
    for (std::size_t i = 1; i < n_; ++i) {
      const Bound bound = bounds_[i - 1];
      if (bound == Bound::none) {
        ++blocks;
        target_[i] = 0.0;
      } else {
        target_[i] = target_[i - 1] + (bound == Bound::lower ? problem_.lower[i - 1] : problem_.upper[i - 1]);
      }
      block_[i] = blocks;
    }
    const double shift = problem_.last - target_[n_ - 1];
    for (std::size_t i = n_; i-- > 0 && block_[i] == blocks;) target_[i] += shift;
    target_[n_ - 1] = problem_.last;
    return blocks + 1;
  }

  /// The minimum under equality in the held bounds, in target_.
  void solve_with_bounds_held() {
    const std::size_t last_block = make_blocks() - 1;
    const std::size_t count = last_block - 1;  // blocks 1 .. last_block - 1 are free
    const std::size_t stride = width_ + 1;
    std::fill(band_.begin(), band_.begin() + static_cast<std::ptrdiff_t>(count * stride), 0.0);
    std::fill(unknowns_.begin(), unknowns_.begin() + static_cast<std::ptrdiff_t>(count), 0.0);
    const auto is_free = [last_block](std::size_t block) { return block != 0 && block != last_block; };
    for (std::size_t i = 0; i < n_; ++i) {
      const bool row_free = is_free(block_[i]);
      const std::size_t row = block_[i] - 1;
      if (row_free) {
        unknowns_[row] += problem_.right_side[i] - problem_.at(i, 0) * target_[i];
        band_[row * stride] += problem_.at(i, 0);
      }
      const std::size_t end = std::min(n_, i + stride);
      for (std::size_t j = i + 1; j < end; ++j) {
        const double entry = problem_.at(i, j - i);
        const bool column_free = is_free(block_[j]);
        const std::size_t column = block_[j] - 1;
        if (row_free) unknowns_[row] -= entry * target_[j];
        if (column_free) unknowns_[column] -= entry * target_[i];
        if (row_free && column_free)
          band_[row * stride + (column - row)] += row == column ? 2.0 * entry : entry;
      }
    }
    solve_band(count);
    for (std::size_t i = 0; i < n_; ++i) {
      if (is_free(block_[i])) target_[i] += unknowns_[block_[i] - 1];
    }
  }

  /// Square-root-free Cholesky of band_ in place, then both substitutions in unknowns_.
  void solve_band(std::size_t count) {
    const std::size_t stride = width_ + 1;
    for (std::size_t i = 0; i < count; ++i) {
      double* row = band_.data() + i * stride;
      const std::size_t reach = std::min(width_, count - 1 - i);
      const double inverse = 1.0 / row[0];
      for (std::size_t k = 1; k <= reach; ++k) {
        if (row[k] == 0.0) continue;
        const double factor = row[k] * inverse;
        double* below = band_.data() + (i + k) * stride;
        for (std::size_t l = k; l <= reach; ++l) below[l - k] -= factor * row[l];
        unknowns_[i + k] -= factor * unknowns_[i];
      }
    }
    for (std::size_t i = count; i-- > 0;) {
      const double* row = band_.data() + i * stride;
      const std::size_t reach = std::min(width_, count - 1 - i);
      double sum = unknowns_[i];
      for (std::size_t k = 1; k <= reach; ++k) sum -= row[k] * unknowns_[i + k];
      unknowns_[i] = sum / row[0];
    }
  }

  /// Goes from current_ to target_, or as far as the first bound on the way, which is then held. True:
  /// stopped by one.
  bool move_towards_target() {
    double share = 1.0;
    std::size_t stop = n_;
    std::size_t free_increments = 0;
    for (std::size_t i = 0; i + 1 < n_; ++i) {
      if (bounds_[i] != Bound::none) continue;
      ++free_increments;
      const double from = current_[i + 1] - current_[i];
      const double to = target_[i + 1] - target_[i];
      const double bound = to < from ? problem_.lower[i] : problem_.upper[i];
      const double room = to < from ? from - bound : bound - from;
      const double way = to < from ? from - to : to - from;
      if (way <= room + slack(i)) continue;
      const double reachable = std::max(room, 0.0) / way;
      if (reachable < share) {
        share = reachable;
        stop = i;
      }
    }
    // The only free increment is what the others leave over: it can miss its bound by rounding alone.
    if (stop == n_ || free_increments == 1) {
      current_ = target_;
      return false;
    }
    bounds_[stop] =
        target_[stop + 1] - target_[stop] < current_[stop + 1] - current_[stop] ? Bound::lower : Bound::upper;
    for (std::size_t i = 0; i < n_; ++i) current_[i] += share * (target_[i] - current_[i]);
    return true;
  }

  /// Forces of the held bounds at current_: the gradient, summed along each block from a free end of it.
  void find_multipliers() {
    gradient();
    std::fill(multipliers_.begin(), multipliers_.end(), 0.0);
    const std::size_t last_block = block_[n_ - 1];
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < n_; ++i) {
      if (block_[i] == 0) continue;
      sum = i > 0 && block_[i - 1] != block_[i] ? -unknowns_[i] : sum - unknowns_[i];
      if (bounds_[i] != Bound::none) multipliers_[i] = sum;
    }
    sum = 0.0;
    for (std::size_t i = n_; i-- > 1;) {
      if (block_[i] != 0 || block_[i] == last_block) continue;
      sum += unknowns_[i];
      if (bounds_[i - 1] != Bound::none) multipliers_[i - 1] = sum;
    }
  }

  /// Nc - r at current_, in unknowns_.
  void gradient() {
    for (std::size_t i = 0; i < n_; ++i)
      unknowns_[i] = problem_.at(i, 0) * current_[i] - problem_.right_side[i];
    for (std::size_t i = 0; i < n_; ++i) {
      const std::size_t reach = std::min(width_, n_ - 1 - i);
      for (std::size_t k = 1; k <= reach; ++k) {
        unknowns_[i] += problem_.at(i, k) * current_[i + k];
        unknowns_[i + k] += problem_.at(i, k) * current_[i];
      }
    }
  }

  /// Lets go of the bound that pulls the wrong way most. False: none does.
  bool release_one() {
    double worst = no_force_;
    std::size_t which = n_;
    for (std::size_t i = 0; i + 1 < n_; ++i) {
      const double pull = bounds_[i] == Bound::lower ? -multipliers_[i] : multipliers_[i];
      if (bounds_[i] != Bound::none && pull > worst) {
        worst = pull;
        which = i;
      }
    }
    if (which == n_) return false;
    bounds_[which] = Bound::none;
    return true;
  }

  const MonotoneProblem& problem_;
  std::size_t n_;
  std::size_t width_;
  std::vector<double> current_;     ///< feasible
  std::vector<Bound> bounds_;       ///< the working set: bounds held with equality
  std::vector<std::size_t> block_;  ///< of each coefficient
  std::vector<double> target_;      ///< minimum for the working set
  std::vector<double> multipliers_;
  std::vector<double> band_;      ///< workspace: the reduced system
  std::vector<double> unknowns_;  ///< workspace
  double no_force_ = 0.0;
};

}  // namespace

MonotoneProblem::MonotoneProblem(std::size_t n, std::size_t width)
    : bandwidth(width), band(n * (width + 1)), right_side(n), lower(n - 1), upper(n - 1) {}

MonotoneSolution solve_monotone(const MonotoneProblem& problem, std::vector<double> start) {
  return ActiveSet(problem, std::move(start)).run();
}

std::vector<double> solve_unbounded(const MonotoneProblem& problem) {
  return ActiveSet(problem, std::vector<double>(problem.size())).unbounded();
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
