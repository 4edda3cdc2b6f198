#include "shape/trigonometry.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace tandem {
inline namespace v0 {
namespace {

// Taylor series; on |x| <= pi/4 the first term left out is below 1e-19.
double sine_series(double x) {
  const double z = x * x;
  double sum = 0.0;
  for (int n = 17; n >= 3; n -= 2) sum = (1.0 + sum) * (-z / (n * (n - 1)));
  return x + x * sum;
}

double cosine_series(double x) {
  const double z = x * x;
  double sum = 0.0;
  for (int n = 18; n >= 2; n -= 2) sum = (1.0 + sum) * (-z / (n * (n - 1)));
  return 1.0 + sum;
}

}  // namespace

CosSin cos_sin_degrees(double degrees) {
  if (!std::isfinite(degrees)) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    return {kNan, kNan};
  }
  const double turn = std::fmod(degrees, 360.0);
  const double quadrant = std::floor(turn / 90.0 + 0.5);
  const double x = (turn - 90.0 * quadrant) * (std::numbers::pi / 180.0);
  const double c = cosine_series(x);
  const double s = sine_series(x);
  switch ((static_cast<int>(quadrant) + 8) % 4) {
    case 0:
      return {c, s};
    case 1:
      return {-s + 0.0, c};  // + 0.0: no negative zero at the exact angles
    case 2:
      return {-c, -s + 0.0};
    default:
      return {s, -c};
  }
}

double angle_degrees(double re, double im) {
  const double radius = std::sqrt(re * re + im * im);
  if (!(radius > 0.0)) return 0.0;
  // Newton's method from the middle of the quadrant.
  double degrees = re >= 0.0 ? (im >= 0.0 ? 45.0 : 315.0) : (im >= 0.0 ? 135.0 : 225.0);
  for (int round = 0; round < 8; ++round) {
    const CosSin w = cos_sin_degrees(degrees);
    degrees += (im * w.cosine - re * w.sine) / radius * (180.0 / std::numbers::pi);
  }
  return degrees;
}

}  // namespace v0
}  // namespace tandem
