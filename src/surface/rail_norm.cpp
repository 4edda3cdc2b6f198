#include "surface/rail_norm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "match/vector.h"
#include "tandem/surface/developable.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// [C] eq. (4) in R^n: <T1,T2> - <T1,d><T2,d>/|d|^2; d = 0: <T1,T2>.
double anti_twist(const NormArguments& pair) {
  double along1 = 0.0;
  double along2 = 0.0;
  double square = 0.0;
  for (std::size_t c = 0; c < pair.point1.size(); ++c) {
    const double d = pair.point2[c] - pair.point1[c];
    along1 += pair.tangent1[c] * d;
    along2 += pair.tangent2[c] * d;
    square += d * d;
  }
  const double product = dot(pair.tangent1, pair.tangent2);
  return square > 0.0 ? product - along1 * along2 / square : product;
}

RailValue space_value(const NormArguments& pair) {
  // Rounding may lift a product of unit vectors above 1.
  return {std::max(0.0, 1.0 - anti_twist(pair)), dot(pair.tangent1, pair.tangent2)};
}

}  // namespace

UserNorm space_norm() {
  return [](const NormArguments& pair) {
    const RailValue value = space_value(pair);
    return NormValue{value.cost, value.value < 0.0};
  };
}

RailNorm space_rail_norm() {
  return space_value;
}

RailNorm planar_rail_norm(double sigma) {
  return [sigma](const NormArguments& pair) {
    std::array<double, 2> d = {pair.point2[0] - pair.point1[0], pair.point2[1] - pair.point1[1]};
    if (normalize(d) == 0.0) {
      const double product = dot(pair.tangent1, pair.tangent2);
      return RailValue{1.0 - product, product};
    }
    const double first = sigma * cross(d, pair.tangent1);
    const double second = sigma * cross(d, pair.tangent2);
    const double worse = std::min(first, second);
    const double value = worse >= 0.0 ? first * second : worse;
    return RailValue{std::max(0.0, 1.0 - value), worse};
  };
}

RailNorm developable_rail_norm(double largest_inclination) {
  return [largest_inclination](const NormArguments& pair) {
    const Ruling ruling = ruling_of(pair);
    const double half = std::sin(0.5 * ruling.warp);
    return RailValue{2.0 * half * half,
                     std::min(std::cos(ruling.warp), largest_inclination - ruling.inclination)};
  };
}

RailNorm tangent_rail_norm() {
  return [](const NormArguments& pair) {
    const double product = dot(pair.tangent1, pair.tangent2);
    return RailValue{std::max(0.0, 1.0 - product), product};
  };
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
