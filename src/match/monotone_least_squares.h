#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tandem {
inline namespace v0 {
namespace detail {

/// Minimise 1/2 c'Nc - r'c over n coefficients c with c[0] and c[n-1] given and every increment c[i+1] - c[i]
/// within [lower[i], upper[i]]. N is symmetric, positive definite and banded.
struct MonotoneProblem {
  /// n coefficients, all zero; `bandwidth` diagonals above the main one, >= 1.
  MonotoneProblem(std::size_t n, std::size_t bandwidth);

  [[nodiscard]] std::size_t size() const { return right_side.size(); }
  /// N(i, i + k), 0 <= k <= bandwidth.
  [[nodiscard]] double& at(std::size_t i, std::size_t k) { return band[i * (bandwidth + 1) + k]; }
  [[nodiscard]] double at(std::size_t i, std::size_t k) const { return band[i * (bandwidth + 1) + k]; }

  std::size_t bandwidth;
  std::vector<double> band;        ///< n * (bandwidth + 1)
  std::vector<double> right_side;  ///< r, n
  std::vector<double> lower;       ///< n - 1
  std::vector<double> upper;       ///< n - 1, >= lower
  double first = 0.0;
  double last = 1.0;
};

struct MonotoneSolution {
  std::vector<double> coefficients;
  /// n - 1, the force with which a bound holds its increment: > 0 at the lower bound, < 0 at the upper one, 0
  /// at none.
  std::vector<double> multipliers;
  int solves = 0;        ///< linear systems solved
  bool optimal = false;  ///< the Karush-Kuhn-Tucker conditions hold to rounding
};

/// The exact minimum by a primal active set method.
///
/// An increment at its bound ties its two coefficients together; so a working set of bounds makes blocks of
/// coefficients with fixed differences, one unknown each, and the reduced system keeps the bandwidth: O(n
/// bandwidth^2) per solve. `start` must be feasible; the nearer it is, the fewer solves. Every iterate is
/// feasible, the result as well when the limit on the number of solves (which guards against cycling by
/// rounding) is reached. Source: Nocedal and Wright, Numerical Optimization, algorithm 16.3.
[[nodiscard]] MonotoneSolution solve_monotone(const MonotoneProblem& problem, std::vector<double> start);

/// The minimum without the bounds on the increments.
[[nodiscard]] std::vector<double> solve_unbounded(const MonotoneProblem& problem);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
