// The three-step programmes by themselves, on one thread: in fixed point, as recognition runs them, and in
// doubles, as match() does. Beside them the yardstick of bench/match_bench.cpp. TANDEM_PAIRS: curve_pairs.h.
#include <benchmark/benchmark.h>

#include <chrono>
#include <limits>

#include "curve_pairs.h"
#include "match/fixed_costs.h"
#include "match/start_family.h"
#include "tandem/match/norm.h"
#include "tandem/match/samples.h"

namespace {

using namespace tandem;
using namespace tandem::bench;
using detail::PathFamily;
using detail::SkewTable;

detail::TangentPlanes tangents_of(const Samples& samples) {
  detail::TangentPlanes t{std::vector<std::vector<double>>(static_cast<std::size_t>(samples.dim()))};
  for (std::size_t c = 0; c < t.planes.size(); ++c) {
    for (std::size_t i = 0; i < samples.size(); ++i) t.planes[c].push_back(samples.tangents_out[i][c]);
  }
  return t;
}

/// The costs of two curves' nodes, in either kind of numbers.
SkewTable<std::int32_t> table_of(const Samples& a, const Samples& b, std::int32_t) {
  return std::move(fixed_tangent_costs(tangents_of(a), tangents_of(b), a.cyclic).table);
}
SkewTable<double> table_of(const Samples& a, const Samples& b, double) {
  const NodeTable nodes = node_costs(a, b, NormKind::tangent);
  SkewTable<double> table(nodes.rows, nodes.cols + (a.cyclic ? 1 : 0));
  for (std::size_t i = 0; i < nodes.rows; ++i) {
    for (int j = 0; j < table.width(); ++j) {
      const std::size_t k = nodes.index(i, static_cast<std::size_t>(j) % nodes.cols);
      table.at(i, static_cast<std::size_t>(j)) = nodes.cost[k] + 512.0 * nodes.invalid[k];
    }
  }
  return table;
}

/// Shortest of a few runs, in seconds.
template <class Work>
double shortest(int runs, const Work& work) {
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < runs; ++k) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

/// One open programme with its path.
template <class V>
void BM_open(benchmark::State& state) {
  const SampleOptions options{.count = static_cast<int>(state.range(0)), .sampling = Sampling::parameter};
  const auto table = table_of(sample(random_open(1), options), sample(random_open(2), options), V{});
  const PathFamily<V> family{&table, table.rows(), true, {}};
  for (auto _ : state) benchmark::DoNotOptimize(trace_path(family, 0, {}));
}
BENCHMARK(BM_open<std::int32_t>)->ArgName("m")->Arg(100)->Arg(1000)->Arg(3000)->Arg(10000);
BENCHMARK(BM_open<double>)->ArgName("m")->Arg(100)->Arg(1000)->Arg(3000);

/// The best of all starts with its path, one direction.
template <class V>
double time_closed(const Pair& pair, int m) {
  const SampleOptions options{.count = m, .cyclic = true};
  const auto table = table_of(sample(pair.a, options), sample(pair.b, options), V{});
  const PathFamily<V> family{&table, table.rows() + 1, false, {}};
  return shortest(m >= 1000 ? 1 : 5, [&] {
    const auto best = detail::StartFamily<V>(family, 1).best({});
    benchmark::DoNotOptimize(trace_path(family, best.start, {}));
  });
}

template <class V>
void BM_closed_random(benchmark::State& state) {
  const int m = static_cast<int>(state.range(0));
  time_pairs(state, random_pairs(), [m](const Pair& p) { return time_closed<V>(p, m); });
}
template <class V>
void BM_closed_hard(benchmark::State& state) {
  const int m = static_cast<int>(state.range(0));
  time_pairs(state, hard_pairs(), [m](const Pair& p) { return time_closed<V>(p, m); });
}
template <class V>
void BM_closed_file(benchmark::State& state) {
  const int m = static_cast<int>(state.range(0));
  time_pairs(state, file_pairs(), [m](const Pair& p) { return time_closed<V>(p, m); });
}
#define TANDEM_CLOSED_BENCHMARK(name) \
  BENCHMARK(name)->ArgName("m")->Arg(100)->Arg(300)->Arg(1000)->Iterations(3)->Unit(benchmark::kMillisecond)
TANDEM_CLOSED_BENCHMARK(BM_closed_random<std::int32_t>);
TANDEM_CLOSED_BENCHMARK(BM_closed_random<double>);
TANDEM_CLOSED_BENCHMARK(BM_closed_hard<std::int32_t>);
TANDEM_CLOSED_BENCHMARK(BM_closed_file<std::int32_t>);
TANDEM_CLOSED_BENCHMARK(BM_closed_file<double>);

/// Fixed-point costs of two loops of 100 nodes.
void BM_fixed_costs(benchmark::State& state) {
  const Pair pair = random_pairs().front();
  const detail::TangentPlanes a = tangents_of(sample(pair.a, {.count = 100, .cyclic = true}));
  const detail::TangentPlanes b = tangents_of(sample(pair.b, {.count = 100, .cyclic = true}));
  for (auto _ : state) benchmark::DoNotOptimize(fixed_tangent_costs(a, b, true));
}
BENCHMARK(BM_fixed_costs);

}  // namespace
