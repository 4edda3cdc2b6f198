#pragma once

#include <algorithm>
#include <vector>

#include "curve/random_curves.h"
#include "tandem/surface/surface.h"

namespace tandem::testing {

/// Deterministic random surfaces: same seed, same surface.
class RandomSurfaces {
 public:
  explicit RandomSurfaces(unsigned seed) : curves_(seed) {}

  RandomCurves& curves() { return curves_; }

  Surface surface(int p, int q, int dim, bool rational, bool clamped) {
    std::vector<double> u = curves_.knots(p, curves_.integer(1, 4), clamped, -1.0, 2.0);
    std::vector<double> v = curves_.knots(q, curves_.integer(1, 4), clamped, 0.5, 4.0);
    const std::size_t m = u.size() - static_cast<std::size_t>(p) - 1;
    const std::size_t n = v.size() - static_cast<std::size_t>(q) - 1;
    Points points = curves_.points(dim, m * n);
    return Surface({p, q}, {std::move(u), std::move(v)}, std::move(points),
                   rational ? curves_.weights(m * n) : std::vector<double>{});
  }

  /// Any degrees up to 4, any kind.
  Surface any(int dim) {
    const bool rational = curves_.integer(0, 1) == 1;
    const bool clamped = curves_.integer(0, 1) == 1;
    return surface(curves_.integer(1, 4), curves_.integer(1, 4), dim, rational, clamped);
  }

 private:
  RandomCurves curves_;
};

/// Parameters all over a domain, the knots among them.
inline std::vector<double> probes(const Surface& surface, Along along, int count = 7) {
  const Interval domain = surface.domain(along);
  std::vector<double> result;
  for (int i = 0; i <= count; ++i) result.push_back(domain.lo + domain.length() * i / count);
  for (const double knot : surface.knots(along)) {
    if (domain.contains(knot)) result.push_back(knot);
  }
  return result;
}

/// Largest distance of a(u, v) and b(u, v) over the probes of a.
inline double largest_gap(const Surface& a, const Surface& b) {
  double gap = 0.0;
  for (const double u : probes(a, Along::u)) {
    for (const double v : probes(a, Along::v))
      gap = std::max(gap, distance(a.evaluate(u, v), b.evaluate(u, v)));
  }
  return gap;
}

}  // namespace tandem::testing
