#include "tandem/surface/developable.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "match/vector.h"

namespace tandem {
inline namespace v0 {
namespace {

/// Parts of unit vectors across a ruling that are shorter than this are rounding of none.
constexpr double kAlong = 1e-12;

}  // namespace

Ruling ruling_of(const NormArguments& pair) {
  const std::size_t dim = pair.point1.size();
  Point d(dim);
  for (std::size_t c = 0; c < dim; ++c) d[c] = pair.point2[c] - pair.point1[c];
  Ruling ruling;
  if (detail::normalize(d) == 0.0) return ruling;

  const double along1 = detail::dot(pair.tangent1, d);
  const double along2 = detail::dot(pair.tangent2, d);
  double across1 = 0.0;
  double across2 = 0.0;
  double mean = 0.0;
  for (std::size_t c = 0; c < dim; ++c) {
    const double x = pair.tangent1[c] - along1 * d[c];
    const double y = pair.tangent2[c] - along2 * d[c];
    across1 += x * x;
    across2 += y * y;
    const double sum = pair.tangent1[c] + pair.tangent2[c];
    mean += sum * sum;
  }
  if (mean > kAlong * kAlong) {
    ruling.inclination = std::asin(std::min(1.0, std::fabs(along1 + along2) / std::sqrt(mean)));
  }
  if (std::min(across1, across2) <= kAlong * kAlong) return ruling;
  // From the sine and the cosine of half the angle: the arc cosine alone would lose half of the digits of
  // small angles, which are those that matter.
  double difference = 0.0;
  double sum = 0.0;
  const double scale1 = 1.0 / std::sqrt(across1);
  const double scale2 = 1.0 / std::sqrt(across2);
  for (std::size_t c = 0; c < dim; ++c) {
    const double x = scale1 * (pair.tangent1[c] - along1 * d[c]);
    const double y = scale2 * (pair.tangent2[c] - along2 * d[c]);
    difference += (x - y) * (x - y);
    sum += (x + y) * (x + y);
  }
  ruling.warp = 2.0 * std::atan2(std::sqrt(difference), std::sqrt(sum));
  return ruling;
}

UserNorm developable_norm(double largest_inclination) {
  return [largest_inclination](const NormArguments& pair) {
    const Ruling ruling = ruling_of(pair);
    const double half = std::sin(0.5 * ruling.warp);
    return NormValue{2.0 * half * half,
                     ruling.warp > 0.5 * std::numbers::pi || ruling.inclination > largest_inclination};
  };
}

}  // namespace v0
}  // namespace tandem
