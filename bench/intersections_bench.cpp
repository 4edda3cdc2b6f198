#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "tandem/shape/intersections.h"
#include "tandem/shape/path_builder.h"

namespace {

using namespace tandem;

/// A gear with rounded teeth and a round hole: two lines and two curves a tooth, as icons are made of.
std::vector<CubicPath> gear(int teeth) {
  PathBuilder builder;
  const auto at = [](double r, double angle) { return Vec2{r * std::cos(angle), r * std::sin(angle)}; };
  const double step = 2.0 * 3.141592653589793 / teeth;
  builder.move_to(at(8, 0));
  for (int i = 0; i < teeth; ++i) {
    const double angle = i * step;
    builder.line_to(at(10, angle + 0.2 * step));
    builder.quad_to(at(10.5, angle + 0.3 * step), at(10, angle + 0.4 * step));
    builder.line_to(at(8, angle + 0.6 * step));
    builder.quad_to(at(7.8, angle + 0.8 * step), at(8, angle + step));
  }
  builder.close();
  builder.move_to(at(3, 0));
  builder.arc_to({3, 3}, 0, false, false, at(-3, 0));
  builder.arc_to({3, 3}, 0, false, false, at(3, 0));
  builder.close();
  return builder.take();
}

/// What an in-between of a morph costs to check: the verdict "simple", which looks at everything.
void BM_IsSimple(benchmark::State& state) {
  const std::vector<CubicPath> paths = gear(static_cast<int>(state.range(0)));
  const std::vector<PathView> views = view_paths(paths);
  CrossingFinder finder;
  bool simple = true;
  for (auto _ : state) simple = simple && finder.is_simple(views);
  if (!simple) state.SkipWithError("the gear crosses itself");
  std::size_t segments = 0;
  for (const CubicPath& path : paths) segments += path.segment_count();
  state.counters["segments"] = static_cast<double>(segments);
}
BENCHMARK(BM_IsSimple)->Arg(4)->Arg(13)->Arg(60);

void BM_FoldFraction(benchmark::State& state) {
  const std::vector<CubicPath> paths = gear(static_cast<int>(state.range(0)));
  const std::vector<PathView> views = view_paths(paths);
  CrossingFinder finder;
  for (auto _ : state) benchmark::DoNotOptimize(finder.fold_fraction(views));
}
BENCHMARK(BM_FoldFraction)->Arg(4)->Arg(13)->Arg(60);

}  // namespace
