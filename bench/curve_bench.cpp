// What sampling does with a curve, thousands of times: evaluation and arc length.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "curve/evaluator.h"
#include "tandem/curve/arc_length.h"
#include "tandem/curve/compatible.h"
#include "tandem/curve/edit.h"

namespace tandem {
namespace {

Curve wave(int degree, std::size_t n, bool rational) {
  Points points(2, n);
  std::vector<double> weights(rational ? n : 0);
  for (std::size_t i = 0; i < n; ++i) {
    points[i][0] = static_cast<double>(i);
    points[i][1] = std::sin(0.7 * static_cast<double>(i));
    if (rational) weights[i] = 1.0 + 0.5 * std::sin(static_cast<double>(i));
  }
  return Curve::clamped_uniform(degree, std::move(points), std::move(weights));
}

// One point and first derivative; arguments: degree, rational.
void BM_PointAndDerivative(benchmark::State& state) {
  const Curve curve = wave(static_cast<int>(state.range(0)), 40, state.range(1) != 0);
  const detail::Evaluator evaluator(curve);
  double p[2];
  double d[2];
  double t = 0.0;
  for (auto _ : state) {
    evaluator.point_and_derivative(t, Side::right, p, d);
    benchmark::DoNotOptimize(p);
    benchmark::DoNotOptimize(d);
    t += 0.00917;
    if (t > 1.0) t -= 1.0;
  }
}
BENCHMARK(BM_PointAndDerivative)->Args({1, 0})->Args({2, 0})->Args({3, 0})->Args({5, 0})->Args({3, 1});

void BM_Evaluate(benchmark::State& state) {
  const Curve curve = wave(3, 40, false);
  double t = 0.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(curve.evaluate(t));
    t += 0.00917;
    if (t > 1.0) t -= 1.0;
  }
}
BENCHMARK(BM_Evaluate);

void BM_ArcLengthBuild(benchmark::State& state) {
  const Curve curve = wave(3, 40, state.range(0) != 0);
  for (auto _ : state)
    benchmark::DoNotOptimize(ArcLength(curve, std::pow(10.0, -static_cast<double>(state.range(1)))));
}
BENCHMARK(BM_ArcLengthBuild)->Args({0, 10})->Args({0, 6})->Args({1, 10})->Unit(benchmark::kMicrosecond);

void BM_ParameterAtLength(benchmark::State& state) {
  const Curve curve = wave(3, 40, state.range(0) != 0);
  const ArcLength length(curve);
  double s = 0.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(length.parameter_at(s * length.length()));
    s += 0.00917;
    if (s > 1.0) s -= 1.0;
  }
}
BENCHMARK(BM_ParameterAtLength)->Arg(0)->Arg(1);

void BM_MakeCompatible(benchmark::State& state) {
  const std::vector<Curve> curves{wave(3, 40, false), wave(static_cast<int>(state.range(0)), 33, false)};
  for (auto _ : state) benchmark::DoNotOptimize(make_compatible(curves));
}
BENCHMARK(BM_MakeCompatible)->Arg(3)->Arg(2)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace tandem
