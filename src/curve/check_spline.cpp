#include "curve/check_spline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Sums and differences of a few numbers of this size still fit into a double.
constexpr double kLargest = 1e304;
// Products of several weights, and of weights with coordinates near 1, still fit.
constexpr double kLargestWeight = 1e100;

void check_number(double x, const char* what, std::size_t index) {
  if (!std::isfinite(x))
    throw InvalidArgument(fmt::format("{} {} is {}, expected a finite number", what, index, x));
  if (std::abs(x) > kLargest) {
    throw InvalidArgument(fmt::format("{} {} is {}, expected at most {} in size", what, index, x, kLargest));
  }
}

}  // namespace

void check_knots(int degree, const std::vector<double>& knots) {
  const auto p = static_cast<std::size_t>(degree);
  for (std::size_t i = 0; i < knots.size(); ++i) {
    check_number(knots[i], "knot", i);
    if (i > 0 && knots[i] < knots[i - 1]) {
      throw InvalidArgument(
          fmt::format("knot {} is {}, before knot {} ({})", i, knots[i], i - 1, knots[i - 1]));
    }
  }
  const double lo = knots[p];
  const double hi = knots[knots.size() - p - 1];
  if (!(hi - lo >= std::numeric_limits<double>::min())) {
    throw InvalidArgument(
        fmt::format("the domain [{}, {}] (knots {} and {}) is empty", lo, hi, p, knots.size() - p - 1));
  }
  for (std::size_t i = 0; i + p < knots.size(); ++i) {
    const bool interior = lo < knots[i] && knots[i] < hi;
    if (interior && knots[i + p] == knots[i]) {
      throw InvalidArgument(
          fmt::format("knot {} ({}) has a multiplicity above {}, the degree: the curve would break there", i,
                      knots[i], degree));
    }
    if (i + p + 1 < knots.size() && knots[i + p + 1] == knots[i]) {
      throw InvalidArgument(fmt::format("knot {} ({}) has a multiplicity above {}, the degree plus one", i,
                                        knots[i], degree + 1));
    }
  }
}

void check_points(const Points& points) {
  const auto dim = static_cast<std::size_t>(points.dim());
  const std::span<const double> data = points.data();
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (std::abs(data[i]) <= kLargest) continue;  // false for NaN
    check_number(data[i], fmt::format("coordinate {} of control point", i % dim).c_str(), i / dim);
  }
}

void check_weights(const std::vector<double>& weights) {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double w = weights[i];
    if (!(w > 0.0)) throw InvalidArgument(fmt::format("weight {} is {}, expected a positive number", i, w));
    if (!(1.0 / kLargestWeight <= w && w <= kLargestWeight)) {
      throw InvalidArgument(fmt::format("weight {} is {}, expected a number between {} and {}", i, w,
                                        1.0 / kLargestWeight, kLargestWeight));
    }
  }
}

double box_diagonal(const Points& points) {
  const std::size_t n = points.size();
  const auto dim = static_cast<std::size_t>(points.dim());
  const double* data = points.data().data();
  double largest = 0.0;
  double sum = 0.0;
  for (std::size_t c = 0; c < dim; ++c) {
    double lo = data[c];
    double hi = data[c];
    for (std::size_t i = 1; i < n; ++i) {
      lo = std::min(lo, data[i * dim + c]);
      hi = std::max(hi, data[i * dim + c]);
    }
    const double side = hi - lo;
    // Running scaled sum of squares, as in LAPACK's dnrm2.
    if (side > largest) {
      sum = 1.0 + sum * (largest / side) * (largest / side);
      largest = side;
    } else if (side > 0.0) {
      sum += (side / largest) * (side / largest);
    }
  }
  return largest * std::sqrt(sum);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
