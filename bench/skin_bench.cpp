// Skins and solids, matching included.
#include <benchmark/benchmark.h>

#include <utility>
#include <vector>

#include "bell_sections.h"
#include "tandem/surface/loft.h"
#include "tandem/surface/skin.h"
#include "tandem/surface/solid.h"

namespace tandem::bench {
namespace {

// Ten sections of 50 control points: at most 100 ms.
void BM_Skin(benchmark::State& state) {
  const std::vector<Curve> given = bell_sections(10, 50, state.range(0) != 0);
  for (auto _ : state) benchmark::DoNotOptimize(skin(given));
}
BENCHMARK(BM_Skin)->Name("skin")->ArgName("closed")->Arg(0)->Arg(1)->MeasureProcessCPUTime()->Unit(
    benchmark::kMillisecond);

void BM_SkinJointly(benchmark::State& state) {
  const std::vector<Curve> given = bell_sections(10, 50, false);
  for (auto _ : state) benchmark::DoNotOptimize(skin(given, {.matching = SkinMatching::joint}));
}
BENCHMARK(BM_SkinJointly)->Name("skin_jointly")->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

// What is left when the sections are in step: interpolation alone.
void BM_Loft(benchmark::State& state) {
  const std::vector<Curve> given = skin(bell_sections(10, 50, false)).sections;
  for (auto _ : state) benchmark::DoNotOptimize(loft(given));
}
BENCHMARK(BM_Loft)->Name("loft")->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

void BM_ContoursToSolid(benchmark::State& state) {
  std::vector<std::vector<Curve>> levels;
  for (Curve& curve : bell_sections(10, 50, true)) levels.push_back({std::move(curve)});
  for (auto _ : state) benchmark::DoNotOptimize(contours_to_solid(levels));
}
BENCHMARK(BM_ContoursToSolid)
    ->Name("contours_to_solid")
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tandem::bench
