#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "tandem/morph/path_morph.h"
#include "tandem/shape/path_builder.h"

namespace {

using namespace tandem;

/// A star of `points` points with round notches: lines and cubics, as icons are made of.
Shape star(int points, double inner) {
  PathBuilder builder;
  for (int i = 0; i < 2 * points; ++i) {
    const double angle = 3.141592653589793 * i / points;
    const double r = i % 2 == 0 ? 10.0 : inner;
    const Vec2 p{r * std::cos(angle), r * std::sin(angle)};
    if (i == 0) {
      builder.move_to(p);
    } else if (i % 2 == 0) {
      builder.line_to(p);
    } else {
      builder.quad_to({1.1 * p.x, 1.1 * p.y}, p);
    }
  }
  builder.close();
  return to_shape(builder.take());
}

const Morph& morph() {
  static const std::vector<Shape> keys{star(5, 4.0), star(8, 7.0)};
  static const Morph result(keys);
  return result;
}

/// One in-between as exact curves.
void BM_MorphAt(benchmark::State& state) {
  double s = 0.0;
  for (auto _ : state) {
    s = s > 1.0 ? 0.0 : s + 0.01;
    benchmark::DoNotOptimize(morph().at(s));
  }
  state.counters["control_points"] = static_cast<double>(morph().keys(0)[0].size());
}
BENCHMARK(BM_MorphAt);

/// One in-between as cubics, what an animation asks for sixty times a second.
void BM_PathMorphAt(benchmark::State& state) {
  const PathMorph paths(morph());
  double s = 0.0;
  for (auto _ : state) {
    s = s > 1.0 ? 0.0 : s + 0.01;
    benchmark::DoNotOptimize(paths.at(s));
  }
  state.counters["segments"] = static_cast<double>(paths.contours()[0].lines.size());
}
BENCHMARK(BM_PathMorphAt);

/// The least that has to be done: the blend of the same number of coordinates.
void BM_PlainBlend(benchmark::State& state) {
  const PathMorph paths(morph());
  const auto a = paths.contours()[0].keys[0].control_points().data();
  const auto b = paths.contours()[0].keys[1].control_points().data();
  double s = 0.0;
  for (auto _ : state) {
    s = s > 1.0 ? 0.0 : s + 0.01;
    std::vector<double> blend(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) blend[i] = (1.0 - s) * a[i] + s * b[i];
    benchmark::DoNotOptimize(blend.data());
  }
}
BENCHMARK(BM_PlainBlend);

}  // namespace
