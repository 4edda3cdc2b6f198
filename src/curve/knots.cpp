#include "tandem/curve/knots.h"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

std::vector<double> clamped_uniform_knots(int degree, std::size_t n) {
  if (degree < 0) throw InvalidArgument(fmt::format("the degree is {}, expected at least 0", degree));
  const auto p = static_cast<std::size_t>(degree);
  if (n <= p) {
    throw InvalidArgument(
        fmt::format("{} control points are too few for degree {}, expected at least {}", n, degree, p + 1));
  }
  std::vector<double> knots(n + p + 1, 0.0);
  const double spans = static_cast<double>(n - p);
  for (std::size_t i = p + 1; i < n; ++i) knots[i] = static_cast<double>(i - p) / spans;
  std::fill(knots.begin() + static_cast<std::ptrdiff_t>(n), knots.end(), 1.0);
  return knots;
}

std::vector<Knot> distinct_knots(std::span<const double> knots) {
  std::vector<Knot> distinct;
  for (const double value : knots) {
    if (distinct.empty() || distinct.back().value != value) distinct.push_back({value, 0});
    ++distinct.back().multiplicity;
  }
  return distinct;
}

int multiplicity(std::span<const double> knots, double t) {
  const auto [first, last] = std::equal_range(knots.begin(), knots.end(), t);
  return static_cast<int>(last - first);
}

std::size_t find_span(std::span<const double> knots, int degree, double t) {
  const auto p = static_cast<std::size_t>(degree);
  const std::size_t n = knots.size() - p - 1;
  const double hi = knots[n];
  // The right end belongs to the last non-empty span; NaN is sent to the first.
  if (t >= hi) {
    const auto at = std::lower_bound(knots.begin(), knots.end(), hi);
    return static_cast<std::size_t>(at - knots.begin()) - 1;
  }
  const auto begin = knots.begin() + static_cast<std::ptrdiff_t>(p);
  const auto end = knots.begin() + static_cast<std::ptrdiff_t>(n);
  const auto at = std::upper_bound(begin, end, t > knots[p] ? t : knots[p]);
  return static_cast<std::size_t>(at - knots.begin()) - 1;
}

}  // namespace v0
}  // namespace tandem
