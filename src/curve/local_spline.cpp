#include "curve/local_spline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curve/scratch.h"
#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace detail {

std::size_t span_on_side(std::span<const double> knots, int degree, double t, Side side) noexcept {
  std::size_t k = find_span(knots, degree, t);
  if (side == Side::left && t == knots[k] && t > knots[static_cast<std::size_t>(degree)]) {
    while (knots[k] == t) --k;
  }
  return k;
}

void basis(const double* knot, int degree, double t, double* value, double* slopes) {
  value[0] = 1.0;
  for (int j = 1; j <= degree; ++j) {
    double saved = 0.0;
    for (int r = 0; r < j; ++r) {
      const double lo = knot[r + 1 - j];
      const double length = knot[r + 1] - lo;
      const double upper = value[r] * ((t - lo) / length);
      if (slopes != nullptr && j == degree) slopes[r] = value[r] / length;
      value[r] = saved + (value[r] - upper);
      saved = upper;
    }
    value[j] = saved;
  }
}

void local_derivatives(const double* knot, int degree, double t, int order, std::size_t stride, double* local,
                       double* rows) {
  Scratch<kStackDegree + 1> value(static_cast<std::size_t>(degree) + 1);
  std::fill(rows, rows + (static_cast<std::size_t>(order) + 1) * stride, 0.0);
  for (int r = 0; r <= std::min(order, degree); ++r) {
    const int left = degree - r;  // degree of the r-th derivative
    const auto count = static_cast<std::size_t>(left) + 1;
    for (std::size_t i = 0; r > 0 && i < count; ++i) {
      const double length = knot[1 + i] - knot[static_cast<std::ptrdiff_t>(i) - left];
      for (std::size_t c = 0; c < stride; ++c) {
        double& x = local[i * stride + c];
        x = static_cast<double>(left + 1) * ((local[(i + 1) * stride + c] - x) / length);
      }
    }
    basis(knot, left, t, value.data(), nullptr);
    double* row = rows + static_cast<std::size_t>(r) * stride;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t c = 0; c < stride; ++c) row[c] += value[i] * local[i * stride + c];
    }
  }
}

double saturated(double x) {
  constexpr double kMax = std::numeric_limits<double>::max();
  if (std::abs(x) <= kMax) return x;
  if (std::isnan(x)) return 0.0;
  return x > 0.0 ? kMax : -kMax;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
