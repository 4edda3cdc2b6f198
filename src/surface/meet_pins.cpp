#include "surface/meet_pins.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Pins are met within this share of v's range, a little above rounding. One round does where pins lie apart;
/// where they share coefficients it takes some more.
constexpr double kMetWithin = 1e-14;
constexpr int kMostRounds = 50;
/// Coefficients at each end of a loop's law that make its value and slope there.
constexpr std::size_t kAtSeam = 2;

bool increasing(const Points& values) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (!(values[i - 1][0] < values[i][0])) return false;
  }
  return true;
}

}  // namespace

std::optional<Curve> meet_pins(const Curve& law, std::span<const ParameterPair> pins, bool loop) {
  const auto degree = static_cast<std::size_t>(law.degree());
  Points coefficients = law.control_points();
  const std::size_t n = coefficients.size();
  const std::size_t fixed = loop ? kAtSeam : 1;
  const double wanted = kMetWithin * (coefficients.back()[0] - coefficients.front()[0]);
  for (int round = 0; round < kMostRounds; ++round) {
    bool met = true;
    for (const ParameterPair& pin : pins) {
      const Curve now(law.degree(), law.knots(), coefficients);
      const double gap = pin.v - now.evaluate(pin.u)[0];
      if (std::abs(gap) <= wanted) continue;
      met = false;
      const std::size_t first = find_span(law.knots(), law.degree(), pin.u) - degree;
      if (first < fixed || first + degree + fixed >= n) return std::nullopt;
      for (std::size_t i = first; i <= first + degree; ++i) coefficients[i][0] += gap;
    }
    if (!increasing(coefficients)) return std::nullopt;
    if (met) return Curve(law.degree(), law.knots(), std::move(coefficients));
  }
  return std::nullopt;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
