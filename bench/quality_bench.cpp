#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "tandem/morph/quality.h"
#include "tandem/shape/path_builder.h"

namespace {

using namespace tandem;

/// A gear of lines and curves, 60 segments with 15 teeth; `depth` of its teeth.
std::vector<CubicPath> gear(int teeth, double depth) {
  PathBuilder builder;
  const double step = 2.0 * 3.141592653589793 / teeth;
  const auto at = [](double r, double angle) { return Vec2{r * std::cos(angle), r * std::sin(angle)}; };
  builder.move_to(at(8, 0));
  for (int i = 0; i < teeth; ++i) {
    const double angle = i * step;
    builder.line_to(at(8 + depth, angle + 0.2 * step));
    builder.quad_to(at(8.5 + depth, angle + 0.3 * step), at(8 + depth, angle + 0.4 * step));
    builder.line_to(at(8, angle + 0.6 * step));
    builder.quad_to(at(7.8, angle + 0.8 * step), at(8, angle + step));
  }
  builder.close();
  return builder.take();
}

/// The report on one candidate of a morph: 20 in-betweens of 60 segments, all of them good.
void BM_MeasureQuality(benchmark::State& state) {
  const CubicPath a = gear(15, 2.0).front();
  const CubicPath b = gear(15, 4.0).front();
  std::vector<double> points;
  std::vector<PathView> views(1);
  const PathSampler sampler = [&](double s) -> std::span<const PathView> {
    const auto from = a.control_points().data();
    const auto to = b.control_points().data();
    points.resize(from.size());
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = (1.0 - s) * from[i] + s * to[i];
    views[0] = {points, true};
    return views;
  };
  for (auto _ : state) {
    if (measure_quality(sampler).faulty > 0) state.SkipWithError("an in-between crosses itself");
  }
  state.counters["segments"] = static_cast<double>(a.segment_count());
}
BENCHMARK(BM_MeasureQuality);

}  // namespace
