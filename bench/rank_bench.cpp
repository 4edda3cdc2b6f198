#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/rank/rank.h"

namespace {

using tandem::Curve;
using tandem::Points;
using tandem::ShapeDescriptor;

double uniform(std::mt19937& random, double lo, double hi) {
  return lo + (hi - lo) * (static_cast<double>(random()) / 4294967296.0);
}

/// A closed polygon or (every other) a smooth closed curve, turned at random.
Curve random_shape(std::mt19937& random) {
  const std::size_t n = 5 + random() % 16;
  const double turn = uniform(random, 0.0, 6.283185307179586);
  Points points(2, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = turn + 6.283185307179586 * (static_cast<double>(i) + uniform(random, -0.3, 0.3)) /
                                    static_cast<double>(n);
    const double radius = uniform(random, 0.4, 2.0);
    points.push_back(std::vector<double>{radius * std::cos(angle), radius * std::sin(angle)});
  }
  const std::vector<double> first(points[0].begin(), points[0].end());
  points.push_back(first);
  return Curve::clamped_uniform(random() % 2 == 0 ? 1 : 3, std::move(points));
}

const std::vector<ShapeDescriptor>& shapes() {
  static const std::vector<ShapeDescriptor> all = [] {
    std::mt19937 random(1);
    std::vector<ShapeDescriptor> made;
    for (int k = 0; k < 10'000; ++k) made.push_back(tandem::describe(random_shape(random)));
    return made;
  }();
  return all;
}

/// A shape of m = 100 from its curve.
void BM_describe(benchmark::State& state) {
  std::mt19937 random(2);
  const Curve shape = random_shape(random);
  for (auto _ : state) benchmark::DoNotOptimize(tandem::describe(shape));
}
BENCHMARK(BM_describe);

/// One pair, m = 100; arguments: rotate, mirror.
void BM_compare(benchmark::State& state) {
  const tandem::CompareOptions options{.rotate = state.range(0) != 0, .mirror = state.range(1) != 0};
  const tandem::ShapeComparer comparer(shapes()[0], options);
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(comparer.compare(shapes()[k = (k + 1) % 1000]));
}
BENCHMARK(BM_compare)->Args({0, 0})->Args({0, 1})->Args({1, 0})->Args({1, 1})->Unit(benchmark::kMicrosecond);

/// One query against 10,000 closed shapes, the best 100; arguments: rotate and mirror, prune. All threads.
void BM_rank(benchmark::State& state) {
  const bool free = state.range(0) != 0;
  const tandem::RankOptions options{
      .compare = {.rotate = free, .mirror = free}, .top = 100, .prune = state.range(1) != 0};
  std::size_t pruned = 0;
  for (auto _ : state) pruned = rank(shapes()[0], shapes(), options).pruned;
  state.counters["pruned"] = static_cast<double>(pruned);
}
BENCHMARK(BM_rank)
    ->Args({1, 1})
    ->Args({1, 0})
    ->Args({0, 1})
    ->Args({0, 0})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
