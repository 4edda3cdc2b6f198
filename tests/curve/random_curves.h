#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <vector>

#include "tandem/curve/curve.h"

namespace tandem::testing {

/// Deterministic random curves for tests: same seed, same curve, everywhere.
class RandomCurves {
 public:
  explicit RandomCurves(unsigned seed) : engine_(seed) {}

  double uniform(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(engine_() >> 8) / 16777216.0);
  }
  int integer(int lo, int hi) {
    return lo + static_cast<int>(engine_() % static_cast<unsigned>(hi - lo + 1));
  }

  Points points(int dim, std::size_t n, double size = 1.0) {
    Points result(dim, n);
    for (double& x : result.data()) x = uniform(-size, size);
    return result;
  }

  /// n in [0.1, 10], evenly in the logarithm.
  std::vector<double> weights(std::size_t n) {
    std::vector<double> result(n);
    for (double& w : result) w = std::pow(10.0, uniform(-1.0, 1.0));
    return result;
  }

  /// Knots over [lo, hi] with repeated ones; unclamped ends stick out at random.
  std::vector<double> knots(int degree, int spans, bool clamped, double lo = 0.0, double hi = 1.0) {
    std::vector<double> breaks(static_cast<std::size_t>(spans) + 1, lo);
    double sum = 0.0;
    std::vector<double> lengths(static_cast<std::size_t>(spans));
    for (double& length : lengths) sum += length = std::pow(10.0, uniform(-1.5, 0.0));
    double at = 0.0;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      at += lengths[i];
      breaks[i + 1] = lo + (hi - lo) * (at / sum);
    }
    breaks.back() = hi;
    std::vector<double> result;
    const auto order = static_cast<std::size_t>(degree) + 1;
    if (clamped) {
      result.assign(order, lo);
    } else {
      for (int i = degree; i > 0; --i)
        result.push_back(lo - 0.3 * (hi - lo) * (i > 1 ? (i + 1) / 2 : integer(0, 1)));
      result.push_back(lo);
    }
    for (std::size_t i = 1; i + 1 < breaks.size(); ++i) {
      const int copies = integer(0, 1) == 0 ? 1 : integer(1, degree);
      for (int c = 0; c < copies; ++c) result.push_back(breaks[i]);
    }
    if (clamped) {
      result.insert(result.end(), order, hi);
    } else {
      result.push_back(hi);
      for (int i = 1; i <= degree; ++i)
        result.push_back(hi + 0.2 * (hi - lo) * (i > 1 ? (i + 1) / 2 : integer(0, 1)));
    }
    return result;
  }

  Curve curve(int degree, int dim, int spans, bool rational, bool clamped, double lo = 0.0, double hi = 1.0) {
    std::vector<double> u = knots(degree, spans, clamped, lo, hi);
    const std::size_t n = u.size() - static_cast<std::size_t>(degree) - 1;
    Points p = points(dim, n);
    return Curve(degree, std::move(u), std::move(p), rational ? weights(n) : std::vector<double>{});
  }

  /// Any degree up to 5, any kind.
  Curve any(int dim) {
    const bool rational = integer(0, 1) == 1;
    return curve(integer(1, 5), dim, integer(1, 6), rational, integer(0, 1) == 1, uniform(-3, 0),
                 uniform(1, 4));
  }

 private:
  std::mt19937 engine_;
};

/// Parameters all over a domain: a grid, the ends, and the knots with their neighbourhoods.
inline std::vector<double> probes(const Curve& curve, int count = 37) {
  const Interval domain = curve.domain();
  std::vector<double> result;
  for (int i = 0; i <= count; ++i) result.push_back(domain.lo + domain.length() * i / count);
  for (const double knot : curve.knots()) {
    for (const double step : {-1e-9, 0.0, 1e-9}) {
      const double t = knot + step * domain.length();
      if (domain.contains(t)) result.push_back(t);
    }
  }
  return result;
}

inline double norm(std::span<const double> v) {
  double length = 0.0;
  for (const double x : v) length = std::hypot(length, x);
  return length;
}

inline double distance(const Point& a, const Point& b) {
  double length = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) length = std::hypot(length, a[i] - b[i]);
  return length;
}

/// Largest distance of a(t) and b(t) over the probes of a.
inline double largest_gap(const Curve& a, const Curve& b) {
  double gap = 0.0;
  for (const double t : probes(a)) gap = std::max(gap, distance(a.evaluate(t), b.evaluate(t)));
  return gap;
}

}  // namespace tandem::testing
