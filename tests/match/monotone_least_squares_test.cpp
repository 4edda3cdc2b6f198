#include "match/monotone_least_squares.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem::detail {
namespace {

double objective(const MonotoneProblem& problem, const std::vector<double>& c) {
  double sum = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    sum += (0.5 * problem.at(i, 0) * c[i] - problem.right_side[i]) * c[i];
    for (std::size_t k = 1; k <= problem.bandwidth && i + k < c.size(); ++k)
      sum += problem.at(i, k) * c[i] * c[i + k];
  }
  return sum;
}

std::vector<double> gradient(const MonotoneProblem& problem, const std::vector<double>& c) {
  std::vector<double> result(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) {
    result[i] += problem.at(i, 0) * c[i] - problem.right_side[i];
    for (std::size_t k = 1; k <= problem.bandwidth && i + k < c.size(); ++k) {
      result[i] += problem.at(i, k) * c[i + k];
      result[i + k] += problem.at(i, k) * c[i];
    }
  }
  return result;
}

std::vector<double> uniform_start(const MonotoneProblem& problem) {
  std::vector<double> start;
  const double n = static_cast<double>(problem.size());
  for (std::size_t i = 0; i < problem.size(); ++i) start.push_back(static_cast<double>(i) / (n - 1.0));
  start.back() = 1.0;
  return start;
}

/// Random data through random banded rows (each a convex combination), bounds as shares of the mean
/// increment.
MonotoneProblem random_problem(std::size_t n, std::size_t bandwidth, double lower, double upper) {
  MonotoneProblem problem(n, bandwidth);
  const auto number = [] { return *rc::gen::inRange(0, 1001) / 1000.0; };
  const auto data = *rc::gen::inRange<std::size_t>(0, 60);
  for (std::size_t l = 0; l < data; ++l) {
    const auto first = *rc::gen::inRange<std::size_t>(0, n - std::min(bandwidth, n - 1));
    std::vector<double> row(std::min(bandwidth + 1, n - first));
    double sum = 0.0;
    for (double& entry : row) sum += entry = number() + 1e-3;
    const double y = number() * 3.0 - 1.0;
    for (std::size_t j = 0; j < row.size(); ++j) {
      problem.right_side[first + j] += row[j] / sum * y;
      for (std::size_t k = j; k < row.size(); ++k)
        problem.at(first + j, k - j) += row[j] * row[k] / (sum * sum);
    }
  }
  for (std::size_t i = 0; i < n; ++i) problem.at(i, 0) += 1e-6;
  const double mean = 1.0 / static_cast<double>(n - 1);
  std::fill(problem.lower.begin(), problem.lower.end(), lower * mean);
  std::fill(problem.upper.begin(), problem.upper.end(), upper * mean);
  return problem;
}

/// The Karush-Kuhn-Tucker conditions, which are sufficient here: feasible; stationary with the multipliers;
/// each multiplier of the right sign and zero off its bound.
void expect_optimal(const MonotoneProblem& problem, const MonotoneSolution& solution) {
  const std::vector<double>& c = solution.coefficients;
  const std::vector<double>& force = solution.multipliers;
  double scale = 1e-6;
  for (std::size_t i = 0; i < c.size(); ++i) scale += problem.at(i, 0);
  RC_ASSERT(solution.optimal);
  RC_ASSERT(c.front() == problem.first);
  RC_ASSERT(c.back() == problem.last);
  const std::vector<double> g = gradient(problem, c);
  for (std::size_t i = 0; i + 1 < c.size(); ++i) {
    const double increment = c[i + 1] - c[i];
    RC_ASSERT(increment >= problem.lower[i] - 1e-14);
    RC_ASSERT(increment <= problem.upper[i] + 1e-14);
    if (force[i] > 1e-12 * scale) RC_ASSERT(std::abs(increment - problem.lower[i]) <= 1e-13);
    if (force[i] < -1e-12 * scale) RC_ASSERT(std::abs(increment - problem.upper[i]) <= 1e-13);
  }
  for (std::size_t i = 1; i + 1 < c.size(); ++i) {
    RC_ASSERT(std::abs(g[i] - (force[i - 1] - force[i])) <= 1e-12 * scale);
  }
}

TEST(MonotoneLeastSquares, SatisfiesTheOptimalityConditions) {
  EXPECT_TRUE(rc::check([] {
    const auto n = *rc::gen::inRange<std::size_t>(2, 30);
    const auto bandwidth = *rc::gen::inRange<std::size_t>(1, 5);
    const double lower = *rc::gen::element(1e-6, 1e-3, 0.3, 0.9);
    const MonotoneProblem problem = random_problem(n, bandwidth, lower, 1.0 / lower);
    expect_optimal(problem, solve_monotone(problem, uniform_start(problem)));
  }));
}

TEST(MonotoneLeastSquares, DoesNotDependOnTheStart) {
  EXPECT_TRUE(rc::check([] {
    const auto n = *rc::gen::inRange<std::size_t>(3, 20);
    const MonotoneProblem problem = random_problem(n, 2, 0.01, 5.0);
    const std::vector<double> from_uniform = solve_monotone(problem, uniform_start(problem)).coefficients;
    // Everything pushed against the lower bound, the rest in as few increments as the upper bound allows.
    std::vector<double> start(n);
    double rest = 1.0;
    for (const double bound : problem.lower) rest -= bound;
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const double more = std::min(rest, problem.upper[i] - problem.lower[i]);
      start[i + 1] = start[i] + problem.lower[i] + more;
      rest -= more;
    }
    start.back() = 1.0;
    const MonotoneSolution solution = solve_monotone(problem, start);
    expect_optimal(problem, solution);
    for (std::size_t i = 0; i < n; ++i) {
      // Only the ridge of 1e-6 decides where there are no data: rounding of 1e-15 is magnified by its
      // inverse.
      RC_ASSERT(std::abs(solution.coefficients[i] - from_uniform[i]) <= 1e-8);
    }
  }));
}

/// Every combination of held bounds, each solved densely: the best feasible one is the minimum.
std::vector<double> by_brute_force(const MonotoneProblem& problem) {
  const std::size_t n = problem.size();
  std::vector<double> best;
  double least = std::numeric_limits<double>::infinity();
  int combinations = 1;
  for (std::size_t i = 0; i + 1 < n; ++i) combinations *= 3;
  for (int code = 0; code < combinations; ++code) {
    // c = offset + sum over blocks; block 0 is anchored at the start, the last one at the end.
    std::vector<int> bound(n - 1);
    int rest = code;
    for (int& b : bound) {
      b = rest % 3;
      rest /= 3;
    }
    if (std::find(bound.begin(), bound.end(), 0) == bound.end()) continue;
    std::vector<std::size_t> block(n, 0);
    std::vector<double> offset(n, 0.0);
    offset[0] = problem.first;
    for (std::size_t i = 0; i + 1 < n; ++i) {
      block[i + 1] = block[i] + (bound[i] == 0 ? 1 : 0);
      offset[i + 1] = bound[i] == 0 ? 0.0 : offset[i] + (bound[i] == 1 ? problem.lower[i] : problem.upper[i]);
    }
    const std::size_t last = block[n - 1];
    const double shift = problem.last - offset[n - 1];
    for (std::size_t i = 0; i < n; ++i) {
      if (block[i] == last) offset[i] += shift;
    }
    const std::size_t free = last - 1;
    std::vector<std::vector<double>> a(free, std::vector<double>(free + 1, 0.0));
    for (std::size_t i = 0; i < n; ++i) {
      if (block[i] == 0 || block[i] == last) continue;
      const std::size_t row = block[i] - 1;
      a[row][free] += problem.right_side[i];
      for (std::size_t j = 0; j < n; ++j) {
        const std::size_t distance = i < j ? j - i : i - j;
        if (distance > problem.bandwidth) continue;
        const double entry = problem.at(std::min(i, j), distance);
        a[row][free] -= entry * offset[j];
        if (block[j] != 0 && block[j] != last) a[row][block[j] - 1] += entry;
      }
    }
    for (std::size_t p = 0; p < free; ++p) {
      for (std::size_t r = 0; r < free; ++r) {
        if (r == p) continue;
        const double factor = a[r][p] / a[p][p];
        for (std::size_t k = p; k <= free; ++k) a[r][k] -= factor * a[p][k];
      }
    }
    std::vector<double> c = offset;
    for (std::size_t i = 0; i < n; ++i) {
      if (block[i] != 0 && block[i] != last) c[i] += a[block[i] - 1][free] / a[block[i] - 1][block[i] - 1];
    }
    bool feasible = true;
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const double increment = c[i + 1] - c[i];
      feasible = feasible && increment >= problem.lower[i] - 1e-12 && increment <= problem.upper[i] + 1e-12;
    }
    if (feasible && objective(problem, c) < least) {
      least = objective(problem, c);
      best = c;
    }
  }
  return best;
}

TEST(MonotoneLeastSquares, EqualsBruteForce) {
  EXPECT_TRUE(rc::check([] {
    const auto n = *rc::gen::inRange<std::size_t>(3, 7);
    const auto bandwidth = *rc::gen::inRange<std::size_t>(1, 4);
    const MonotoneProblem problem = random_problem(n, bandwidth, 0.05, 2.0);
    const MonotoneSolution solution = solve_monotone(problem, uniform_start(problem));
    const std::vector<double> expected = by_brute_force(problem);
    double scale = 1e-6;
    for (std::size_t i = 0; i < n; ++i) scale += problem.at(i, 0);
    RC_ASSERT(std::abs(objective(problem, solution.coefficients) - objective(problem, expected)) <=
              1e-12 * scale);
    for (std::size_t i = 0; i < n; ++i) RC_ASSERT(std::abs(solution.coefficients[i] - expected[i]) <= 1e-8);
  }));
}

TEST(MonotoneLeastSquares, MeetsBoundsThatLeaveNoChoice) {
  MonotoneProblem problem(5, 1);
  for (std::size_t i = 0; i < 5; ++i) problem.at(i, 0) = 1.0;
  problem.lower = problem.upper = {0.1, 0.2, 0.3, 0.4};
  const MonotoneSolution solution = solve_monotone(problem, {0.0, 0.1, 0.3, 0.6, 1.0});
  const std::vector<double> expected{0.0, 0.1, 0.3, 0.6, 1.0};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(solution.coefficients[i], expected[i], 1e-15);
}

TEST(MonotoneLeastSquares, PoolsALongStepDown) {
  // Nearly all of the 400 coefficients end in one block, at the mean of its data.
  const std::size_t n = 400;
  MonotoneProblem problem(n, 1);
  for (std::size_t i = 0; i < n; ++i) {
    const double y = i < n / 2 ? 0.75 : 0.25;
    problem.at(i, 0) = 1.0;
    problem.right_side[i] = y;
  }
  std::fill(problem.lower.begin(), problem.lower.end(), 1e-3 / static_cast<double>(n));
  std::fill(problem.upper.begin(), problem.upper.end(), 1.0);
  const MonotoneSolution from_uniform = solve_monotone(problem, uniform_start(problem));
  EXPECT_TRUE(from_uniform.optimal);
  EXPECT_NEAR(from_uniform.coefficients[n / 2], 0.5, 1e-3);
}

}  // namespace
}  // namespace tandem::detail
