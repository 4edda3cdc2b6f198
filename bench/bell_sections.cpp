#include "bell_sections.h"

#include <cmath>
#include <random>
#include <utility>

namespace tandem::bench {
namespace {

constexpr double kPi = 3.14159265358979;

Curve section(unsigned seed, std::size_t n, double z, bool closed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double lo, double hi) { return lo + (hi - lo) * (random() / 4294967296.0); };
  const double bump = uniform(0.2, 0.8);
  const double start = uniform(0.0, 1.0);
  Points points(3, closed ? n + 3 : n);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = static_cast<double>(i % n) / static_cast<double>(closed ? n : n - 1);
    const double at = closed ? x + start : x;
    const double height = std::exp(-60.0 * (1.0 - std::cos(2.0 * kPi * (at - bump))) / 4.0);
    points[i][0] = closed ? (2.0 + height) * std::cos(2.0 * kPi * at) : 10.0 * x;
    points[i][1] = closed ? (2.0 + height) * std::sin(2.0 * kPi * at) : 2.0 * height;
    points[i][2] = z;
  }
  if (!closed) return Curve::clamped_uniform(3, std::move(points));
  std::vector<double> knots;
  for (std::size_t k = 0; k < n + 7; ++k) knots.push_back(static_cast<double>(k));
  return Curve(3, std::move(knots), std::move(points));
}

}  // namespace

std::vector<Curve> bell_sections(std::size_t count, std::size_t n, bool closed) {
  std::vector<Curve> made;
  for (std::size_t k = 0; k < count; ++k) {
    made.push_back(section(static_cast<unsigned>(k + 1), n, static_cast<double>(k), closed));
  }
  return made;
}

}  // namespace tandem::bench
