#include "match/tangent.h"

#include <algorithm>
#include <vector>

#include "match/vector.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Below this share of extent / domain^k a derivative of order k is rounding, not motion.
constexpr double kStandstill = 1e-12;

}  // namespace

double one_sided_tangent(const Evaluator& curve, double t, Side side, double extent,
                         std::span<double> tangent) {
  const auto dim = tangent.size();
  const double period = curve.domain().length();
  std::vector<double> rows;
  double buffer[2 * 16];
  std::span<double> first(buffer, 2 * dim);
  if (2 * dim > std::size(buffer)) {
    rows.resize(2 * dim);
    first = rows;
  }
  curve.point_and_derivative(t, side, first.first(dim), first.subspan(dim));
  std::copy_n(first.begin() + static_cast<std::ptrdiff_t>(dim), dim, tangent.begin());
  const double speed = normalize(tangent);
  if (speed * period > kStandstill * extent) return speed;

  // A rational curve has derivatives of every order; beyond the degree they say nothing new about the
  // direction.
  const int order = std::max(2, curve.degree());
  std::vector<double> all(static_cast<std::size_t>(order + 1) * dim);
  curve.derivatives(t, order, side, all);
  double unit = period;
  for (int k = 2; k <= order; ++k) {
    unit *= period;
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(k) * dim), dim,
                tangent.begin());
    if (normalize(tangent) * unit > kStandstill * extent) {
      if (side == Side::left && k % 2 == 0) {
        for (double& c : tangent) c = -c;
      }
      return speed;
    }
  }
  std::fill(tangent.begin(), tangent.end(), 0.0);
  return speed;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
