#include "match/fixed_costs.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "match/fixed_costs.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace tandem {
inline namespace v0 {
namespace detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// One row of a skewed table: (1 - <a,b>) * scale, rounded. The planes of a run against those of b.
void tangent_row(const double* const* a, const double* const* b, std::size_t dim, std::size_t n, double scale,
                 std::int32_t* out) {
  const hn::ScalableTag<double> d;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  const auto one = hn::Set(d, 1.0);
  const auto scales = hn::Set(d, scale);
  const auto zero = hn::Zero(d);
  // The arrays are padded to whole vectors.
  for (std::size_t j = 0; j < n; j += hn::Lanes(d)) {
    auto dot = zero;
    for (std::size_t c = 0; c < dim; ++c) {
      dot = hn::Add(dot, hn::Mul(hn::LoadU(d, a[c] + j), hn::LoadU(d, b[c] + j)));
    }
    // Rounding may lift a product of unit vectors above 1.
    const auto cost = hn::Max(hn::Sub(one, dot), zero);
    const auto scaled = hn::Add(hn::Mul(cost, scales), hn::Set(d, 0.5));
    hn::StoreU(hn::DemoteTo(di, scaled), di, out + j);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace detail
}  // namespace v0
}  // namespace tandem
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "match/kernel_target.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

TANDEM_KERNEL(tangent_row);

/// A vector of any instruction set may be read past an array's end.
constexpr std::size_t kPadding = 64 / sizeof(double);

}  // namespace

double fixed_quantum(std::size_t rows, std::size_t cols, double most) {
  // A closed path has one node more than rows + cols; the next power of two leaves room for rounding up.
  const double total = most * static_cast<double>(rows + cols + 2);
  return std::scalbn(1.0, std::ilogb(std::max(total, 1e-300)) + 1 - 30);
}

FixedCosts fixed_tangent_costs(const TangentPlanes& a, const TangentPlanes& b, bool cyclic, double weight) {
  const std::size_t rows = a.size();
  const std::size_t cols = b.size();
  const std::size_t width = cols + (cyclic ? 1 : 0);
  const std::size_t dim = a.planes.size();
  FixedCosts costs{SkewTable<std::int32_t>(rows, width), fixed_quantum(rows, width, 2.0 * weight)};
  // Row e holds node (e - j) mod rows of a under column j: a runs backwards, lap after lap.
  const std::size_t span = rows + width + kPadding;
  std::vector<double> backwards(dim * span);
  std::vector<double> columns(dim * (width + kPadding));
  std::vector<const double*> from(dim);
  std::vector<const double*> to(dim);
  for (std::size_t c = 0; c < dim; ++c) {
    double* run = backwards.data() + c * span;
    for (std::size_t k = 0; k < span; ++k) run[k] = a.planes[c][rows - 1 - k % rows];
    double* column = columns.data() + c * (width + kPadding);
    for (std::size_t j = 0; j < width; ++j) column[j] = b.planes[c][j % cols];
    to[c] = column;
  }
  for (std::size_t e = 0; e < rows; ++e) {
    for (std::size_t c = 0; c < dim; ++c) from[c] = backwards.data() + c * span + (rows - 1 - e);
    TANDEM_DISPATCH(tangent_row)
    (from.data(), to.data(), dim, width, 1.0 / costs.quantum, costs.table.diagonal(e));
  }
  return costs;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
#endif
