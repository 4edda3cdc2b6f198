#include "curve/increasing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "curve/bernstein.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Halvings of a piece in search of a place where it decreases. A dip narrower than this cannot be deeper than
// rounding for coefficients of a sensible size.
constexpr int kDeepest = 24;

// Does the polynomial with these Bernstein coefficients fall below -slack somewhere? Then `at` is such a
// place.
bool falls_below(std::vector<double> b, double slack, double lo, double hi, int depth, double& at) {
  const double least = *std::min_element(b.begin(), b.end());
  if (least >= -slack) return false;
  const double middle = 0.5 * (lo + hi);
  if (b.front() < -slack) return at = lo, true;
  if (b.back() < -slack) return at = hi, true;
  if (depth == kDeepest) return false;
  std::vector<double> left(b.size());
  for (std::size_t level = 0; level < left.size(); ++level) {
    left[level] = b[0];
    for (std::size_t i = 0; i + level + 1 < b.size(); ++i) b[i] = 0.5 * b[i] + 0.5 * b[i + 1];
  }
  return falls_below(std::move(left), slack, lo, middle, depth + 1, at) ||
         falls_below(std::move(b), slack, middle, hi, depth + 1, at);
}

// Bernstein coefficients of a positive multiple of the derivative.
std::vector<double> derivative_numerator(const double* piece, int degree, bool rational) {
  const auto n = static_cast<std::size_t>(degree);
  if (!rational) {
    std::vector<double> d(n);
    for (std::size_t i = 0; i < n; ++i) d[i] = piece[i + 1] - piece[i];
    return d;
  }
  // N' W - N W' = sum of w_i w_j (v_j - v_i) (B_j' B_i - ...): formed from value differences, it does not
  // cancel.
  std::vector<double> d(2 * n - 1, 0.0);
  const std::vector<double> lower = binomials(degree - 1);
  const std::vector<double> upper = binomials(2 * degree - 2);
  // With N and W as (1 - x) A + x B of their de Casteljau halves A, B of degree n - 1, N'W - NW' = n (B_N A_W
  // - A_N B_W).
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double value_a = piece[2 * i] / piece[2 * i + 1];
      const double value_b = piece[2 * j + 2] / piece[2 * j + 3];
      d[i + j] += lower[i] * lower[j] * piece[2 * i + 1] * piece[2 * j + 3] * (value_b - value_a);
    }
  }
  for (std::size_t k = 0; k < d.size(); ++k) d[k] /= upper[k];
  return d;
}

}  // namespace

void check_increasing(const Pieces& function, double slack) {
  const auto stride = static_cast<std::size_t>(function.stride);
  for (std::size_t j = 0; j < function.size(); ++j) {
    const double* piece = function[j];
    const auto value = [&](int i) {
      const double* b = piece + static_cast<std::size_t>(i) * stride;
      return function.rational ? b[0] / b[1] : b[0];
    };
    bool rising = true;
    for (int i = 0; i < function.degree; ++i) rising = rising && value(i) <= value(i + 1);
    // An increasing control polygon makes an increasing function (variation diminishing).
    if (rising || function.degree == 1) continue;
    double at = 0.0;
    if (falls_below(derivative_numerator(piece, function.degree, function.rational), slack, 0.0, 1.0, 0,
                    at)) {
      const double lo = function.breaks[j].value;
      const double hi = function.breaks[j + 1].value;
      throw InvalidArgument(
          fmt::format("the inner function is not increasing: it decreases at {}", lo + at * (hi - lo)));
    }
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
