#include "surface/orientation.h"

#include <cmath>
#include <cstddef>

#include "surface/expansion.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

constexpr double kHalfUlp = 0x1p-53;
// Shewchuk's bounds o3derrboundA and ccwerrboundA, relative to the sum of the absolute products.
constexpr double kSpaceBound = (7.0 + 56.0 * kHalfUlp) * kHalfUlp;
constexpr double kPlaneBound = (3.0 + 16.0 * kHalfUlp) * kHalfUlp;

int sign(double x) noexcept {
  return x > 0.0 ? 1 : (x < 0.0 ? -1 : 0);
}

int exact_orientation(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                      const SpacePoint& d) noexcept {
  const auto minor = [&](const SpacePoint& p, const SpacePoint& q) {
    return exact_difference(p[0], d[0]) * exact_difference(q[1], d[1]) -
           exact_difference(q[0], d[0]) * exact_difference(p[1], d[1]);
  };
  return (exact_difference(a[2], d[2]) * minor(b, c) + exact_difference(b[2], d[2]) * minor(c, a) +
          exact_difference(c[2], d[2]) * minor(a, b))
      .sign();
}

}  // namespace

int orientation(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c, const SpacePoint& d) noexcept {
  std::array<SpacePoint, 3> e{};
  for (std::size_t k = 0; k < 3; ++k) {
    e[0][k] = a[k] - d[k];
    e[1][k] = b[k] - d[k];
    e[2][k] = c[k] - d[k];
  }
  double det = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const SpacePoint& p = e[(i + 1) % 3];
    const SpacePoint& q = e[(i + 2) % 3];
    const double pq = p[0] * q[1];
    const double qp = q[0] * p[1];
    det += e[i][2] * (pq - qp);
    size += std::abs(e[i][2]) * (std::abs(pq) + std::abs(qp));
  }
  if (std::abs(det) > kSpaceBound * size + 0x1p-1000) return sign(det);
  return exact_orientation(a, b, c, d);
}

int orientation(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c, std::size_t x,
                std::size_t y) noexcept {
  const double left = (a[x] - c[x]) * (b[y] - c[y]);
  const double right = (a[y] - c[y]) * (b[x] - c[x]);
  const double det = left - right;
  if (std::abs(det) > kPlaneBound * (std::abs(left) + std::abs(right)) + 0x1p-1000) return sign(det);
  return (exact_difference(a[x], c[x]) * exact_difference(b[y], c[y]) -
          exact_difference(a[y], c[y]) * exact_difference(b[x], c[x]))
      .sign();
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
