// From a path to v(u), and the check of the result: what match() does after its programme.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/match/reparametrization.h"
#include "tandem/match/validity.h"

namespace {

/// The paper's kind of path: a staircase of whole steps on an m x m grid along a wavy v(u), `points` nodes or
/// so.
tandem::FitPath staircase(int m) {
  tandem::FitPath path;
  int j = 0;
  for (int i = 0; i < m; ++i) {
    const double u = i / (m - 1.0);
    const double v = u + 0.145 * std::sin(6.283185307179586 * u);
    const int to = i + 1 == m ? m - 1 : static_cast<int>(v * (m - 1) + 0.5);
    path.points.push_back({u, j / (m - 1.0)});
    while (j < to) path.points.push_back({u, ++j / (m - 1.0)});
  }
  return path;
}

/// The elastic kind: strictly increasing, steps of unequal length.
tandem::FitPath slanted(int m) {
  tandem::FitPath path;
  for (int i = 0; i < m; ++i) {
    const double u = i / (m - 1.0);
    path.points.push_back({u, u + 0.12 * std::sin(6.283185307179586 * u) + 0.0009 * std::sin(251.0 * u)});
  }
  path.points.back().v = 1.0;
  path.points.front().v = 0.0;
  return path;
}

void fit_coefficients(benchmark::State& state) {
  const tandem::FitPath path = staircase(static_cast<int>(state.range(0)));
  tandem::ReductionOptions options;
  options.coefficients = static_cast<int>(state.range(1));
  options.order = static_cast<int>(state.range(2));
  for (auto _ : state) benchmark::DoNotOptimize(tandem::fit(path, options));
  state.counters["points"] = static_cast<double>(path.points.size());
}
BENCHMARK(fit_coefficients)
    ->Args({100, 20, 2})
    ->Args({100, 20, 4})
    ->Args({300, 50, 3})
    ->Unit(benchmark::kMicrosecond);

void fit_tolerance(benchmark::State& state) {
  const tandem::FitPath path = slanted(static_cast<int>(state.range(0)));
  tandem::ReductionOptions options;
  options.order = static_cast<int>(state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(tandem::fit(path, options));
  state.counters["coefficients"] = static_cast<double>(tandem::fit(path, options).v.size());
}
BENCHMARK(fit_tolerance)->Args({128, 2})->Args({2000, 2})->Args({128, 4})->Unit(benchmark::kMicrosecond);

tandem::Curve wavy_cubic(std::size_t spans, double phase) {
  tandem::Points points(2, spans + 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(points.size() - 1);
    points[i][0] = t;
    points[i][1] = 0.08 * std::sin(12.0 * t + phase);
  }
  return tandem::Curve::clamped_uniform(3, points);
}

void check_validity(benchmark::State& state) {
  const auto spans = static_cast<std::size_t>(state.range(0));
  const tandem::Curve a = wavy_cubic(spans, 0.0);
  const tandem::Curve b = wavy_cubic(spans, state.range(1) != 0 ? 3.0 : 0.7);
  const auto norm = static_cast<tandem::NormKind>(state.range(2));
  for (auto _ : state) benchmark::DoNotOptimize(tandem::check_validity(a, b, norm));
  state.counters["valid_share"] = tandem::check_validity(a, b, norm).valid_share;
}
BENCHMARK(check_validity)
    ->ArgNames({"spans", "partly_invalid", "norm"})
    ->Args({60, 0, 0})
    ->Args({60, 1, 0})
    ->Args({60, 0, 1})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
