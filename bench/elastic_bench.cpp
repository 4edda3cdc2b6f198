// The elastic programme by itself: chord table, edge costs, path, and the search over starts. No sampling,
// fit or composition.
#include <benchmark/benchmark.h>

#include <ctime>
#include <utility>

#include "curve_pairs.h"
#include "match/search_near.h"
#include "tandem/match/match.h"

namespace {

using namespace tandem;
using namespace tandem::bench;
using detail::Layout;

/// Seconds of the processor: the machine may have other work to do.
double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Every start, both directions, one thread.
double time_closed(const Pair& pair, int m) {
  const SampleOptions options{.count = m, .cyclic = true};
  const Samples a = sample(pair.a, options);
  const Samples b = sample(pair.b, options);
  const double start = cpu_seconds();
  benchmark::DoNotOptimize(detail::search(a, b, {.threads = 1}, Layout::toroidal));
  return cpu_seconds() - start;
}

void BM_elastic_closed_random(benchmark::State& state) {
  const int m = static_cast<int>(state.range(0));
  time_pairs(state, random_pairs(), [m](const Pair& p) { return time_closed(p, m); });
}
BENCHMARK(BM_elastic_closed_random)->ArgName("m")->Arg(128)->Iterations(3)->Unit(benchmark::kMillisecond);

void BM_elastic_closed_hard(benchmark::State& state) {
  const int m = static_cast<int>(state.range(0));
  time_pairs(state, hard_pairs(), [m](const Pair& p) { return time_closed(p, m); });
}
BENCHMARK(BM_elastic_closed_hard)->ArgName("m")->Arg(128)->Iterations(3)->Unit(benchmark::kMillisecond);

void BM_elastic_closed_file(benchmark::State& state) {
  const int m = static_cast<int>(state.range(0));
  time_pairs(state, file_pairs(), [m](const Pair& p) { return time_closed(p, m); });
}
BENCHMARK(BM_elastic_closed_file)->ArgName("m")->Arg(128)->Iterations(3)->Unit(benchmark::kMillisecond);

/// Both directions on a quarter of the samples, then the better one beside that path; not exact.
double time_fast(const Pair& pair, int m) {
  const auto samples = [&](int count) {
    const SampleOptions options{.count = count, .cyclic = true};
    return detail::SamplePair{sample(pair.a, options), sample(pair.b, options)};
  };
  const detail::SamplePair fine = samples(m);
  const detail::SamplePair coarse = samples(m / detail::kCoarsening);
  const double start = cpu_seconds();
  benchmark::DoNotOptimize(detail::search_near(coarse, fine, {.threads = 1}, Layout::toroidal));
  return cpu_seconds() - start;
}

void BM_elastic_fast_random(benchmark::State& state) {
  const int m = static_cast<int>(state.range(0));
  time_pairs(state, random_pairs(), [m](const Pair& p) { return time_fast(p, m); });
}
BENCHMARK(BM_elastic_fast_random)->ArgName("m")->Arg(128)->Iterations(3)->Unit(benchmark::kMillisecond);

void BM_elastic_fast_file(benchmark::State& state) {
  const int m = static_cast<int>(state.range(0));
  time_pairs(state, file_pairs(), [m](const Pair& p) { return time_fast(p, m); });
}
BENCHMARK(BM_elastic_fast_file)->ArgName("m")->Arg(128)->Iterations(3)->Unit(benchmark::kMillisecond);

/// One direction of two open curves, of a pair with a valid path (a curve and the same one a little changed)
/// and of one without.
void BM_elastic_open_programme(benchmark::State& state) {
  const int m = static_cast<int>(state.range(0));
  const Curve first = random_open(1);
  Points points = first.control_points();
  for (std::size_t k = 0; k < points.size(); ++k) points[k][1] *= 0.8;
  const Curve second = state.range(1) != 0 ? Curve::clamped_uniform(3, std::move(points)) : random_open(2);
  const Samples a = sample(first, {.count = m});
  const Samples b = sample(second, {.count = m});
  const MatchOptions options{.direction = Direction::forward, .threads = 1};
  double invalid = 0.0;
  for (auto _ : state) {
    const detail::SearchResult found = detail::search(a, b, options, Layout::open);
    invalid = static_cast<double>(found.path.invalid) * kInvalidQuantum;
  }
  state.counters["invalid_length"] = invalid;
}
BENCHMARK(BM_elastic_open_programme)
    ->ArgNames({"m", "valid"})
    ->Args({100, 1})
    ->Args({100, 0})
    ->Args({1000, 1})
    ->Args({1000, 0});

}  // namespace
