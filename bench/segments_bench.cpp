#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "tandem/match/segments.h"
#include "tandem/morph/segment_blend.h"

namespace {

using namespace tandem;

CubicPath random_loop(std::mt19937& random, std::size_t segments) {
  std::normal_distribution<double> number(0.0, 1.0);
  Points points(2, 3 * segments + 1);
  for (double& x : points.data()) x = number(random);
  for (std::size_t k = 0; k < 2; ++k) points[3 * segments][k] = points[0][k];
  return CubicPath(std::move(points), true);
}

/// A regular polygon with a little noise: every start nearly ties.
CubicPath noisy_ring(std::mt19937& random, std::size_t segments, double size) {
  std::normal_distribution<double> noise(0.0, 0.003);
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < segments; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(segments);
    x.push_back(size * (std::cos(angle) + noise(random)));
    y.push_back(size * (std::sin(angle) + noise(random)));
  }
  Points points(2, 3 * segments + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t from = i / 3 % segments;
    const std::size_t to = (from + 1) % segments;
    const double t = static_cast<double>(i % 3) / 3.0;
    points[i][0] = (1.0 - t) * x[from] + t * x[to];
    points[i][1] = (1.0 - t) * y[from] + t * y[to];
  }
  return CubicPath(std::move(points), true);
}

SegmentOptions options_of(const benchmark::State& state) {
  return {.cost = state.range(1) != 0 ? SegmentCost::paper : SegmentCost::derivative};
}

/// Two random loops of so many segments; 1: the paper's cost.
void BM_segments_random(benchmark::State& state) {
  std::mt19937 random(1);
  const CubicPath a = random_loop(random, static_cast<std::size_t>(state.range(0)));
  const CubicPath b = random_loop(random, static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(match_segments(a, b, options_of(state)));
}
BENCHMARK(BM_segments_random)->ArgsProduct({{20, 100}, {0, 1}})->Unit(benchmark::kMillisecond);

/// Two noisy rings, one ten times as large: the slowest kind that is known.
void BM_segments_rings(benchmark::State& state) {
  std::mt19937 random(1);
  const CubicPath a = noisy_ring(random, static_cast<std::size_t>(state.range(0)), 1.0);
  const CubicPath b = noisy_ring(random, static_cast<std::size_t>(state.range(0)), 10.0);
  for (auto _ : state) benchmark::DoNotOptimize(match_segments(a, b, options_of(state)));
}
BENCHMARK(BM_segments_rings)->ArgsProduct({{20, 100}, {0, 1}})->Unit(benchmark::kMillisecond);

/// One in-between of so many segments into the caller's buffer.
void BM_hermite_blend(benchmark::State& state) {
  std::mt19937 random(1);
  const auto segments = static_cast<std::size_t>(state.range(0));
  const HermiteBlend blend(random_loop(random, segments), random_loop(random, segments));
  std::vector<double> points(2 * (3 * segments + 1));
  for (auto _ : state) {
    blend.at(0.4, points);
    benchmark::DoNotOptimize(points.data());
  }
}
BENCHMARK(BM_hermite_blend)->Arg(20)->Arg(100)->Unit(benchmark::kMicrosecond);

}  // namespace
