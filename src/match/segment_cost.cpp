#include "match/segment_cost.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// One coordinate's part of the integral of |C'(t)|^2, from its control differences. The Gram matrix of the
/// quadratic Bernstein polynomials is [6 3 1; 3 4 3; 1 3 6] / 30 (spec D5).
double energy(double x, double y, double z) {
  return 0.3 * (6.0 * (x * x + z * z) + 4.0 * y * y + 6.0 * y * (x + z) + 2.0 * x * z);
}

/// The polar form of a quadratic with these control values, at (s, t).
double polar(double x, double y, double z, double s, double t) {
  return (1.0 - s) * ((1.0 - t) * x + t * y) + s * ((1.0 - t) * y + t * z);
}

}  // namespace

double derivative_energy(std::span<const double> differences, std::size_t dim) {
  double sum = 0.0;
  for (std::size_t d = 0; d < dim; ++d) {
    sum += energy(differences[d], differences[dim + d], differences[2 * dim + d]);
  }
  return sum;
}

double cost_by_pieces(const SegmentVectors& one, std::size_t i, const SegmentVectors& run, std::size_t first,
                      std::size_t count, SegmentCost cost, double most) {
  const std::size_t dim = one.dim;
  const double* e = one.vector(i, 0).data();
  double whole = 0.0;
  for (std::size_t l = 0; l < count; ++l) whole += run.shares[(first + l) % run.size()];
  double sum = 0.0;
  double lo = 0.0;
  double before = 0.0;
  // The parameters are those of split_parameters(): most of the time goes by here, so no list is made.
  for (std::size_t l = 0; l < count && sum <= most; ++l) {
    before += run.shares[(first + l) % run.size()];
    double hi = whole > 0.0 ? before / whole : static_cast<double>(l + 1) / static_cast<double>(count);
    if (l + 1 == count) hi = 1.0;
    const double h = hi - lo;
    const double* r = run.vector(first + l, 0).data();
    double piece = 0.0;
    for (std::size_t d = 0; d < dim; ++d) {
      const double x = h * polar(e[d], e[dim + d], e[2 * dim + d], lo, lo) - r[d];
      const double y = h * polar(e[d], e[dim + d], e[2 * dim + d], lo, hi) - r[dim + d];
      const double z = h * polar(e[d], e[dim + d], e[2 * dim + d], hi, hi) - r[2 * dim + d];
      piece += cost == SegmentCost::paper ? x * x + y * y + z * z : energy(x, y, z);
    }
    if (cost == SegmentCost::paper) {
      sum += piece;
    } else if (h > 0.0) {
      sum += piece / h;
    }
    lo = hi;
  }
  return sum;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
