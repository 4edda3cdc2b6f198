#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/match/match.h"
#include "tandem/surface/certificate.h"
#include "tandem/surface/ruled.h"
#include "tandem/surface/simple_mesh.h"
#include "tandem/surface/tessellate.h"

namespace {

// Two nested curves with waves of their own.
tandem::Curve wavy(std::size_t count, double radius, double phase, int dim) {
  tandem::Points points(dim, count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count - 1);
    const double r = radius + 0.05 * std::sin(25.0 * t + phase);
    points[i][0] = r * std::cos(4.0 * t);
    points[i][1] = r * std::sin(4.0 * t);
    if (dim == 3) points[i][2] = 0.2 * radius * t;
  }
  return tandem::Curve::clamped_uniform(3, points);
}

tandem::RuledSurface ruled(std::size_t count, int dim) {
  tandem::RuleOptions options;
  options.match.samples = {200, 200};
  return rule(wavy(count, 1.0, 0.0, dim), wavy(count, 1.4, 0.7, dim), options);
}

// The surface that matching makes of curves with that many control points, at m = 200.
void certify_ruled(benchmark::State& state) {
  const tandem::Surface surface =
      ruled(static_cast<std::size_t>(state.range(0)), static_cast<int>(state.range(1))).surface;
  for (auto _ : state) benchmark::DoNotOptimize(tandem::certify(surface));
  state.counters["certified"] = certify(surface).verdict == tandem::Verdict::certified ? 1 : 0;
  state.counters["control_points"] = static_cast<double>(surface.size(tandem::Along::u));
}
BENCHMARK(certify_ruled)
    ->ArgNames({"points", "dim"})
    ->Args({20, 2})
    ->Args({200, 2})
    ->Args({20, 3})
    ->Args({200, 3})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

void simple_mesh(benchmark::State& state) {
  const tandem::Surface surface = ruled(50, 3).surface;
  const tandem::TriangleMesh mesh =
      tessellate(surface, {.chord = std::pow(10.0, -static_cast<double>(state.range(0)))});
  for (auto _ : state) benchmark::DoNotOptimize(tandem::find_simple(mesh));
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
  state.counters["certified"] = find_simple(mesh).verdict == tandem::Verdict::certified ? 1 : 0;
}
BENCHMARK(simple_mesh)
    ->ArgName("digits")
    ->Arg(3)
    ->Arg(6)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
