#include "shape/trigonometry.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace tandem {
inline namespace v0 {
namespace {

// Taylor series in z = x^2 on |x| <= pi/4, where the first term left out is below 1e-17. Written out:
// divisions would take most of the time.
constexpr double reciprocal_factorial(int n) {
  double product = 1.0;
  for (int k = 2; k <= n; ++k) product *= k;
  return 1.0 / product;
}

template <int kFirst, int kLast>
double alternating_series(double z) {
  constexpr double kTerm = kFirst / 2 % 2 == 0 ? reciprocal_factorial(kFirst) : -reciprocal_factorial(kFirst);
  if constexpr (kFirst == kLast) {
    return kTerm;
  } else {
    return kTerm + z * alternating_series<kFirst + 2, kLast>(z);
  }
}

double sine_series(double x) {
  const double z = x * x;
  return x + x * z * alternating_series<3, 17>(z);
}

double cosine_series(double x) {
  const double z = x * x;
  return 1.0 + z * alternating_series<2, 18>(z);
}

// The remainder, as fmod has it; a single turn more takes an exact subtraction.
double below_one_turn(double degrees) {
  const double size = std::fabs(degrees);
  if (size < 360.0) return degrees;
  if (size < 720.0) return degrees > 0.0 ? degrees - 360.0 : degrees + 360.0;
  return std::fmod(degrees, 360.0);
}

}  // namespace

CosSin cos_sin_degrees(double degrees) {
  if (!std::isfinite(degrees)) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    return {kNan, kNan};
  }
  const double turn = below_one_turn(degrees);
  const double nearest = turn / 90.0 + 0.5;
  int quadrant = static_cast<int>(nearest);
  if (nearest < quadrant) --quadrant;  // the floor
  const double x = (turn - 90.0 * quadrant) * (std::numbers::pi / 180.0);
  // By tables: quadrants are as good as random, and wrongly foreseen branches take longer than all the rest.
  const double both[] = {cosine_series(x), sine_series(x)};
  constexpr double kCosineSign[] = {1.0, -1.0, -1.0, 1.0};
  constexpr double kSineSign[] = {1.0, 1.0, -1.0, -1.0};
  const auto q = static_cast<unsigned>(quadrant + 8) % 4;
  // + 0.0: no negative zero at the exact angles
  return {kCosineSign[q] * both[q % 2] + 0.0, kSineSign[q] * both[1 - q % 2] + 0.0};
}

double angle_degrees(double re, double im) {
  const double radius = std::sqrt(re * re + im * im);
  if (!(radius > 0.0)) return 0.0;
  // Newton's method from the middle of the quadrant.
  double degrees = re >= 0.0 ? (im >= 0.0 ? 45.0 : 315.0) : (im >= 0.0 ? 135.0 : 225.0);
  for (int round = 0; round < 8; ++round) {
    const CosSin w = cos_sin_degrees(degrees);
    const double before = degrees;
    degrees += (im * w.cosine - re * w.sine) / radius * (180.0 / std::numbers::pi);
    if (degrees == before) break;
  }
  return degrees;
}

}  // namespace v0
}  // namespace tandem
