#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "curve/random_curves.h"
#include "tandem/curve/curve.h"
#include "tandem/surface/certificate.h"

namespace tandem::testing {

struct CurvePair {
  Curve a;
  Curve b;
};

/// Deterministic random pairs of planar curves over [0,1], some of which make good ruled surfaces.
class PlanarPairs {
 public:
  explicit PlanarPairs(unsigned seed) : random_(seed) {}

  CurvePair next() {
    switch (random_.integer(0, 4)) {
      case 0:
        return strip(3, 3, 1, false);
      case 1:
        return strip(random_.integer(1, 5), random_.integer(2, 4), random_.integer(2, 8), false);
      case 2:
        return strip(random_.integer(2, 4), random_.integer(1, 4), random_.integer(1, 5), true);
      case 3:
        return ring(false);
      default:
        return ring(true);
    }
  }

  RandomCurves& random() { return random_; }

 private:
  // Along a wavy line, and a second one beside it.
  CurvePair strip(int degree_a, int degree_b, int spans, bool rational) {
    const double wave = random_.uniform(0.0, 1.2);
    const double noise = random_.uniform(0.0, 0.12);
    const double width = random_.uniform(0.05, 0.9);
    const double turns = random_.uniform(0.5, 2.0);
    const auto along = [&](int degree, double off) {
      std::vector<double> knots = random_.knots(degree, spans, random_.integer(0, 3) != 0);
      const std::size_t n = knots.size() - static_cast<std::size_t>(degree) - 1;
      Points points(2, n);
      for (std::size_t i = 0; i < n; ++i) {
        double t = 0.0;  // Greville
        for (std::size_t k = 1; k <= static_cast<std::size_t>(degree); ++k) t += knots[i + k] / degree;
        const double phase = 6.2831853 * turns * t;
        points[i][0] = 2.0 * t + random_.uniform(-noise, noise);
        points[i][1] = wave * 0.4 * std::sin(phase) + off + random_.uniform(-noise, noise);
      }
      return Curve(degree, std::move(knots), std::move(points),
                   rational ? random_.weights(n) : std::vector<double>{});
    };
    Curve a = along(degree_a, 0.0);
    return {std::move(a), along(degree_b, width)};
  }

  // Two closed curves, one within the other or not quite.
  CurvePair ring(bool periodic) {
    const auto count = static_cast<std::size_t>(random_.integer(5, 14));
    const double noise = random_.uniform(0.0, 0.35);
    const double inner = random_.uniform(0.2, 0.95);
    const double twist = random_.integer(0, 3) == 0 ? random_.uniform(-2.0, 2.0) : 0.0;
    const auto around = [&](double radius, double turn) {
      const std::size_t degree = periodic ? static_cast<std::size_t>(random_.integer(2, 4)) : 3;
      const std::size_t n = periodic ? count + degree : count + 1;
      Points points(2, n);
      for (std::size_t i = 0; i < n; ++i) {
        if (i >= count) {
          std::copy(points[i - count].begin(), points[i - count].end(), points[i].begin());
          continue;
        }
        const double r = radius * (1.0 + random_.uniform(-noise, noise));
        const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count) + turn;
        points[i][0] = r * std::cos(angle);
        points[i][1] = r * std::sin(angle);
      }
      if (!periodic) return Curve::clamped_uniform(3, std::move(points));
      std::vector<double> knots;
      for (std::size_t i = 0; i <= n + degree; ++i) {
        knots.push_back((static_cast<double>(i) - static_cast<double>(degree)) / static_cast<double>(count));
      }
      return Curve(static_cast<int>(degree), std::move(knots), std::move(points));
    };
    Curve a = around(1.0, 0.0);
    return {std::move(a), around(inner, twist)};
  }

  RandomCurves random_;
};

/// A curve in the plane by de Boor's algorithm in long double: shares nothing with the code under test.
class LongCurve {
 public:
  explicit LongCurve(const Curve& curve) : curve_(curve) {}

  struct At {
    std::array<long double, 2> p{};
    std::array<long double, 2> d{};
  };

  [[nodiscard]] At at(double t) const {
    const std::size_t p = static_cast<std::size_t>(curve_.degree());
    const std::vector<double>& knots = curve_.knots();
    std::size_t k = p;
    while (k + 1 < curve_.size() && knots[k + 1] <= t) ++k;
    std::vector<std::array<long double, 3>> c(p + 1);
    for (std::size_t i = 0; i <= p; ++i) {
      const std::size_t from = k - p + i;
      const long double w = curve_.is_rational() ? curve_.weights()[from] : 1.0L;
      c[i] = {w * curve_.control_points()[from][0], w * curve_.control_points()[from][1], w};
    }
    std::array<long double, 3> speed{};
    for (std::size_t r = 1; r <= p; ++r) {
      if (r == p) {
        const long double span = static_cast<long double>(knots[k + 1]) - knots[k];
        for (std::size_t x = 0; x < 3; ++x)
          speed[x] = static_cast<long double>(p) * (c[p][x] - c[p - 1][x]) / span;
      }
      for (std::size_t i = p; i >= r; --i) {
        const long double lo = knots[k - p + i];
        const long double alpha = (t - lo) / (knots[k + i - r + 1] - lo);
        for (std::size_t x = 0; x < 3; ++x) c[i][x] = (1 - alpha) * c[i - 1][x] + alpha * c[i][x];
      }
    }
    At result;
    for (std::size_t x = 0; x < 2; ++x) {
      result.p[x] = c[p][x] / c[p][2];
      result.d[x] = (speed[x] - speed[2] * result.p[x]) / c[p][2];
    }
    return result;
  }

 private:
  const Curve& curve_;
};

/// R_u x R_v of the ruled surface.
inline long double jacobian(const CurvePair& pair, double u, double v) {
  const LongCurve::At a = LongCurve(pair.a).at(u);
  const LongCurve::At b = LongCurve(pair.b).at(u);
  const long double dx = (1 - v) * a.d[0] + v * b.d[0];
  const long double dy = (1 - v) * a.d[1] + v * b.d[1];
  return dx * (b.p[1] - a.p[1]) - dy * (b.p[0] - a.p[0]);
}

inline std::array<long double, 2> ruled_point(const CurvePair& pair, double u, double v) {
  const LongCurve::At a = LongCurve(pair.a).at(u);
  const LongCurve::At b = LongCurve(pair.b).at(u);
  return {(1 - v) * a.p[0] + v * b.p[0], (1 - v) * a.p[1] + v * b.p[1]};
}

/// The ruled surface by dense samples.
struct DenseSamples {
  bool sign_changes = false;
  bool boundary_crosses = false;
  [[nodiscard]] bool free() const { return !sign_changes && !boundary_crosses; }
};

using LongPoint = std::array<long double, 2>;

inline bool segments_cross(const LongPoint& a, const LongPoint& b, const LongPoint& c, const LongPoint& d) {
  if (std::max(a[0], b[0]) < std::min(c[0], d[0]) || std::max(c[0], d[0]) < std::min(a[0], b[0]) ||
      std::max(a[1], b[1]) < std::min(c[1], d[1]) || std::max(c[1], d[1]) < std::min(a[1], b[1]))
    return false;
  const auto side = [](const LongPoint& p, const LongPoint& q, const LongPoint& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

inline DenseSamples sample_densely(const CurvePair& pair, int count) {
  DenseSamples result;
  bool positive = false;
  bool negative = false;
  std::vector<LongPoint> a;
  std::vector<LongPoint> b;
  const LongCurve of_a(pair.a);
  const LongCurve of_b(pair.b);
  const int stride = 8;  // the boundary needs fewer samples than the Jacobian
  for (int i = 0; i <= count; ++i) {
    const double u = static_cast<double>(i) / count;
    const LongCurve::At p = of_a.at(u);
    const LongCurve::At q = of_b.at(u);
    const long double x = q.p[0] - p.p[0];
    const long double y = q.p[1] - p.p[1];
    for (const auto& d : {p.d, q.d}) {
      const long double value = d[0] * y - d[1] * x;
      positive = positive || value > 0;
      negative = negative || value < 0;
    }
    if (i % stride == 0) {
      a.push_back(p.p);
      b.push_back(q.p);
    }
  }
  result.sign_changes = positive && negative;
  const bool closed = pair.a.is_closed() && pair.b.is_closed();
  if (closed) {  // up to rounding errors; exactly, so that neighbours at the seam do not cross
    a.back() = a.front();
    b.back() = b.front();
  }
  std::vector<std::array<LongPoint, 2>> segments;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) segments.push_back({a[i], a[i + 1]});
  if (!closed) segments.push_back({a.back(), b.back()});
  for (std::size_t i = b.size(); i-- > 1;) segments.push_back({b[i], b[i - 1]});
  if (!closed) segments.push_back({b.front(), a.front()});
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i + 2; j < segments.size(); ++j) {
      if (segments_cross(segments[i][0], segments[i][1], segments[j][0], segments[j][1]))
        result.boundary_crosses = true;
    }
  }
  return result;
}

}  // namespace tandem::testing
