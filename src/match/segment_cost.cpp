#include "match/segment_cost.h"

#include <vector>

namespace tandem {
inline namespace v0 {
namespace detail {

double derivative_energy(std::span<const double> e, std::size_t dim) {
  // The Gram matrix of the quadratic Bernstein polynomials is [6 3 1; 3 4 3; 1 3 6] / 30 (spec D5).
  double sum = 0.0;
  for (std::size_t d = 0; d < dim; ++d) {
    const double x = e[d];
    const double y = e[dim + d];
    const double z = e[2 * dim + d];
    sum += 6.0 * (x * x + z * z) + 4.0 * y * y + 6.0 * y * (x + z) + 2.0 * x * z;
  }
  return 0.3 * sum;
}

namespace {

double sum_of_squares(std::span<const double> x) {
  double sum = 0.0;
  for (double c : x) sum += c * c;
  return sum;
}

/// The polar form of a quadratic with these control values, at (s, t).
double polar(double x, double y, double z, double s, double t) {
  return (1.0 - s) * ((1.0 - t) * x + t * y) + s * ((1.0 - t) * y + t * z);
}

}  // namespace

double cost_by_pieces(const SegmentVectors& one, std::size_t i, const SegmentVectors& run, std::size_t first,
                      std::size_t count, SegmentCost cost, double most) {
  const std::size_t dim = one.dim;
  const auto e0 = one.vector(i, 0);
  const auto e1 = one.vector(i, 1);
  const auto e2 = one.vector(i, 2);
  const std::vector<double> at = split_parameters(run, first, count);
  std::vector<double> gap(3 * dim);
  double sum = 0.0;
  for (std::size_t l = 0; l < count && sum <= most; ++l) {
    const double lo = at[l];
    const double hi = at[l + 1];
    const double h = hi - lo;
    const auto r0 = run.vector(first + l, 0);
    const auto r1 = run.vector(first + l, 1);
    const auto r2 = run.vector(first + l, 2);
    for (std::size_t d = 0; d < dim; ++d) {
      gap[d] = h * polar(e0[d], e1[d], e2[d], lo, lo) - r0[d];
      gap[dim + d] = h * polar(e0[d], e1[d], e2[d], lo, hi) - r1[d];
      gap[2 * dim + d] = h * polar(e0[d], e1[d], e2[d], hi, hi) - r2[d];
    }
    if (cost == SegmentCost::paper) {
      sum += sum_of_squares(gap);
    } else if (h > 0.0) {
      sum += derivative_energy(gap, dim) / h;
    }
  }
  return sum;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
