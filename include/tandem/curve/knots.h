#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/curve/interval.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// A distinct value of a knot vector and how often it stands there.
struct Knot {
  double value = 0.0;
  int multiplicity = 0;
  friend bool operator==(const Knot&, const Knot&) = default;
};

/// n + degree + 1 knots, clamped at both ends of [0,1], with uniform spans between.
/// @throws InvalidArgument degree < 0 or n <= degree
[[nodiscard]] TANDEM_EXPORT std::vector<double> clamped_uniform_knots(int degree, std::size_t n);

/// The distinct values of a non-decreasing knot vector with their multiplicities (equality is exact).
[[nodiscard]] TANDEM_EXPORT std::vector<Knot> distinct_knots(std::span<const double> knots);

/// How often t stands in the knot vector (equality is exact).
[[nodiscard]] TANDEM_EXPORT int multiplicity(std::span<const double> knots, double t);

/// Index k of the non-empty span with knots[k] <= t < knots[k+1], degree <= k < n; t is clamped to the
/// domain, and its right end belongs to the last non-empty span.
[[nodiscard]] TANDEM_EXPORT std::size_t find_span(std::span<const double> knots, int degree, double t);

}  // namespace v0
}  // namespace tandem
