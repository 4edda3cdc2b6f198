// Ruled surfaces of random planar pairs, 200 nodes each: matching, law, exact composition and the report.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "tandem/surface/certificate.h"
#include "tandem/surface/hermite_surface.h"
#include "tandem/surface/ruled.h"

namespace {

using tandem::Curve;
using tandem::Points;

/// An open wavy curve of 40 control points at height z, its waves moved by `phase`.
Curve wave(int dim, double z, double phase, double depth) {
  constexpr std::size_t kPoints = 40;
  Points points(dim, kPoints);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double x = 10.0 * static_cast<double>(i) / (kPoints - 1);
    points[i][0] = x;
    points[i][1] = depth * std::sin(x + phase) + 0.3 * std::sin(3.0 * x) + (dim == 2 ? z : 0.0);
    if (dim == 3) points[i][2] = z + 0.2 * x;
  }
  return Curve::clamped_uniform(3, std::move(points));
}

/// certified: and prove it, as `tandem rule --certify` does; in the plane that is the whole certificate.
void rule(benchmark::State& state, int dim, bool developable, bool certified = false) {
  const Curve a = wave(dim, 0.0, 0.0, 1.0);
  const Curve b = wave(dim, 4.0, 0.7, 1.3);
  tandem::RuleOptions options;
  options.match.samples = {static_cast<int>(state.range(0)), static_cast<int>(state.range(0))};
  options.developable = developable;
  for (auto _ : state) {
    const tandem::RuledSurface ruled = tandem::rule(a, b, options);
    benchmark::DoNotOptimize(ruled.surface.control_points().data().data());
    if (certified) {
      state.counters["certified"] = certify(ruled.surface).verdict == tandem::Verdict::certified ? 1 : 0;
    }
    state.counters["match_ms"] = 1e3 * ruled.match.report.seconds.match;
    state.counters["control_points"] = static_cast<double>(ruled.surface.control_points().size());
  }
}

void rule_planar(benchmark::State& state) {
  rule(state, 2, false);
}
// m = 200: at most 20 ms on the wall.
void rule_planar_certified(benchmark::State& state) {
  rule(state, 2, false, true);
}
void rule_space(benchmark::State& state) {
  rule(state, 3, false);
}
void rule_developable(benchmark::State& state) {
  rule(state, 3, true);
}

void blend_rails(benchmark::State& state) {
  const Curve up = Curve::bezier({{0, 0, 1}, {0, 0, 1}});
  const tandem::Rail first{wave(3, 0.0, 0.0, 1.0), up};
  const tandem::Rail second{wave(3, 4.0, 0.7, 1.3), up};
  for (auto _ : state) {
    const tandem::HermiteSurface blend = tandem::blend_rails(first, second);
    benchmark::DoNotOptimize(blend.surface.control_points().data().data());
  }
}

BENCHMARK(rule_planar)->Arg(100)->Arg(200)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(rule_planar_certified)->Arg(200)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(rule_space)->Arg(100)->Arg(200)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(rule_developable)->Arg(100)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(blend_rails)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

}  // namespace
