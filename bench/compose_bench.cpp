// Composition outer(inner(u)), and beside it the same by the plain way: cut, change domains, join.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "tandem/curve/compose.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"

namespace tandem {
namespace {

Curve wave(int degree, std::size_t n) {
  Points points(2, n);
  for (std::size_t i = 0; i < n; ++i) {
    points[i][0] = static_cast<double>(i);
    points[i][1] = std::sin(0.7 * static_cast<double>(i));
  }
  return Curve::clamped_uniform(degree, std::move(points));
}

// From [0,1] onto [0,1], strictly increasing, no coefficient on a knot of the outer curve.
Curve ramp(int degree, std::size_t n) {
  Points points(1, n);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(n - 1);
    points[i][0] = x + 0.11 * std::sin(6.0 * x) * (1.0 - x) * x;
  }
  return Curve::clamped_uniform(degree, std::move(points));
}

// What a user would write with the editing functions: one subcurve per linear piece, joined.
Curve compose_by_parts(const Curve& outer, const Curve& inner) {
  std::vector<Curve> parts;
  for (std::size_t i = 0; i + 1 < inner.size(); ++i) {
    const Interval values{inner.control_points()[i][0], inner.control_points()[i + 1][0]};
    parts.push_back(with_domain(subcurve(outer, values), {inner.knots()[i + 1], inner.knots()[i + 2]}));
  }
  return join(parts);
}

// The whole of C8's everyday case: a cubic of 40 control points, piecewise linear v with 20 coefficients.
void BM_ComposeCubicWithPiecewiseLinear(benchmark::State& state) {
  const Curve outer = wave(3, 40);
  const Curve inner = ramp(1, 20);
  for (auto _ : state) benchmark::DoNotOptimize(compose(outer, inner));
}
BENCHMARK(BM_ComposeCubicWithPiecewiseLinear)->Unit(benchmark::kMicrosecond);

void BM_ComposeCubicWithPiecewiseLinearByParts(benchmark::State& state) {
  const Curve outer = wave(3, 40);
  const Curve inner = ramp(1, 20);
  for (auto _ : state) benchmark::DoNotOptimize(compose_by_parts(outer, inner));
}
BENCHMARK(BM_ComposeCubicWithPiecewiseLinearByParts)->Unit(benchmark::kMicrosecond);

// Degrees p and q, 40 and 20 coefficients.
void BM_Compose(benchmark::State& state) {
  const Curve outer = wave(static_cast<int>(state.range(0)), 40);
  const Curve inner = ramp(static_cast<int>(state.range(1)), 20);
  for (auto _ : state) benchmark::DoNotOptimize(compose(outer, inner));
}
BENCHMARK(BM_Compose)
    ->Args({1, 1})
    ->Args({2, 1})
    ->Args({1, 3})
    ->Args({2, 2})
    ->Args({3, 3})
    ->Args({5, 4})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace tandem
