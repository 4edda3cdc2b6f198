#include "match/uniform_fit.h"

#include <algorithm>
#include <cmath>

#include "match/monotone_least_squares.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Weight of the pull towards uniform speed, integral of (v' - mean)^2, against the mean of (v - path)^2. Its
/// root is a length, 1e-6 of the domain, below which the fit does not follow the path; it keeps the normal
/// equations solvable (condition <= 1e12) when there are more coefficients than data.
constexpr double kStillness = 1e-12;

/// The degree + 1 basis functions that do not vanish on a span, at every abscissa. The NURBS Book, A2.2.
class BasisTable {
 public:
  BasisTable(std::span<const double> x, std::span<const double> knots, int degree)
      : degree_(static_cast<std::size_t>(degree)),
        first_(x.size()),
        values_(x.size() * (degree_ + 1)),
        left_(degree_ + 1),
        right_(degree_ + 1) {
    std::size_t span = degree_;
    const std::size_t last_span = knots.size() - degree_ - 2;
    for (std::size_t l = 0; l < x.size(); ++l) {
      while (span < last_span && x[l] >= knots[span + 1]) ++span;
      first_[l] = span - degree_;
      evaluate(x[l], knots, span, values_.data() + l * (degree_ + 1));
    }
  }

  /// Index of the first coefficient that counts at abscissa l.
  [[nodiscard]] std::size_t first(std::size_t l) const { return first_[l]; }
  [[nodiscard]] const double* values(std::size_t l) const { return values_.data() + l * (degree_ + 1); }

  [[nodiscard]] double evaluate(std::size_t l, std::span<const double> coefficients) const {
    double sum = 0.0;
    for (std::size_t k = 0; k <= degree_; ++k) sum += values(l)[k] * coefficients[first_[l] + k];
    return sum;
  }

 private:
  void evaluate(double x, std::span<const double> knots, std::size_t span, double* basis) {
    basis[0] = 1.0;
    for (std::size_t j = 1; j <= degree_; ++j) {
      left_[j] = x - knots[span + 1 - j];
      right_[j] = knots[span + j] - x;
      double saved = 0.0;
      for (std::size_t r = 0; r < j; ++r) {
        const double part = basis[r] / (right_[r + 1] + left_[j - r]);
        basis[r] = saved + right_[r + 1] * part;
        saved = left_[j - r] * part;
      }
      basis[j] = saved;
    }
  }

  std::size_t degree_;
  std::vector<std::size_t> first_;
  std::vector<double> values_;
  std::vector<double> left_;
  std::vector<double> right_;
};

std::vector<double> greville_abscissae(std::span<const double> knots, int degree) {
  std::vector<double> abscissae(knots.size() - static_cast<std::size_t>(degree) - 1);
  for (std::size_t i = 0; i < abscissae.size(); ++i) {
    double sum = 0.0;
    for (std::size_t k = 1; k <= static_cast<std::size_t>(degree); ++k) sum += knots[i + k];
    abscissae[i] = sum / degree;
  }
  abscissae.front() = knots.front();
  abscissae.back() = knots.back();
  return abscissae;
}

MonotoneProblem normal_equations(const BasisTable& basis, std::span<const double> y, int degree,
                                 std::span<const double> greville) {
  MonotoneProblem problem(greville.size(), static_cast<std::size_t>(degree));
  for (std::size_t l = 0; l < y.size(); ++l) {
    const double* values = basis.values(l);
    for (std::size_t j = 0; j <= problem.bandwidth; ++j) {
      const std::size_t i = basis.first(l) + j;
      problem.right_side[i] += values[j] * y[l];
      for (std::size_t k = j; k <= problem.bandwidth; ++k) problem.at(i, k - j) += values[j] * values[k];
    }
  }
  return problem;
}

void add_pull_to_uniform_speed(MonotoneProblem& problem, std::span<const double> greville, double data) {
  const double slope = (problem.last - problem.first) / (greville.back() - greville.front());
  for (std::size_t i = 0; i + 1 < problem.size(); ++i) {
    const double weight = kStillness * data / (greville[i + 1] - greville[i]);
    problem.at(i, 0) += weight;
    problem.at(i, 1) -= weight;
    problem.at(i + 1, 0) += weight;
    problem.right_side[i] -= kStillness * data * slope;
    problem.right_side[i + 1] += kStillness * data * slope;
  }
}

double largest_deviation(const BasisTable& basis, std::span<const double> x, std::span<const double> y,
                         std::span<const double> coefficients) {
  double deviation = 0.0;
  for (std::size_t l = 0; l < x.size();) {
    std::size_t end = l + 1;
    while (end < x.size() && x[end] == x[l]) ++end;
    const double value = basis.evaluate(l, coefficients);
    deviation = std::max({deviation, y[l] - value, value - y[end - 1]});
    l = end;
  }
  return deviation;
}

}  // namespace

ScalarFit fit_scalar_spline(std::span<const double> x, std::span<const double> y,
                            std::span<const double> knots, int degree, double first, double last,
                            const SlopeRange& range, const EndSlopes& ends) {
  const BasisTable basis(x, knots, degree);
  const std::vector<double> greville = greville_abscissae(knots, degree);
  const std::size_t n = greville.size();
  MonotoneProblem problem = normal_equations(basis, y, degree, greville);
  problem.first = first;
  problem.last = last;
  add_pull_to_uniform_speed(problem, greville, static_cast<double>(std::max<std::size_t>(x.size(), 1)));
  for (std::size_t i = 0; i + 1 < n; ++i) {
    problem.lower[i] = range.lo * (greville[i + 1] - greville[i]);
    problem.upper[i] = range.hi * (greville[i + 1] - greville[i]);
  }
  std::vector<double> start = solve_unbounded(problem);
  std::vector<std::size_t> fixed = {0, n - 1};
  if (ends.first) {
    start[1] = first + *ends.first * (greville[1] - greville[0]);
    problem.lower.front() = problem.upper.front() = start[1] - first;
    fixed.insert(fixed.begin() + 1, 1);
  }
  if (ends.last) {
    start[n - 2] = last - *ends.last * (greville[n - 1] - greville[n - 2]);
    problem.lower.back() = problem.upper.back() = last - start[n - 2];
    fixed.insert(fixed.end() - 1, n - 2);
  }
  start = limit_slopes(greville, start, fixed, range);

  ScalarFit fit;
  fit.coefficients = solve_monotone(problem, std::move(start)).coefficients;
  fit.deviation = largest_deviation(basis, x, y, fit.coefficients);
  return fit;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
