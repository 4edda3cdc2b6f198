#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tandem/curve/curve.h"

/// Curves that the benchmarks of the programmes have in common.
namespace tandem::bench {

struct Pair {
  Curve a;
  Curve b;
};

/// An open cubic B-spline of 40 control points.
[[nodiscard]] Curve random_open(unsigned seed);

/// 100 pairs of closed cubic B-splines, from smooth to rough.
[[nodiscard]] std::vector<Pair> random_pairs();

/// Symmetric and featureless outlines, where many starts are as good as one another.
[[nodiscard]] std::vector<Pair> hard_pairs();

/// Pairs of real outlines: those of the set closed1 in the file that the environment names,
/// TANDEM_PAIRS=FILE, with {"pairs": [{"set": ..., "a": {"d": path data}, "b": ...}]}. None without it.
[[nodiscard]] std::vector<Pair> file_pairs();

/// run(pair) returns seconds. The best of a few tries counts for every pair: what it takes when nothing else
/// runs.
template <class Run>
void time_pairs(benchmark::State& state, const std::vector<Pair>& pairs, const Run& run) {
  if (pairs.empty()) {
    state.SkipWithError("no pairs: set TANDEM_PAIRS");
    return;
  }
  std::vector<double> best(pairs.size(), 1e9);
  for (auto _ : state) {
    for (std::size_t k = 0; k < pairs.size(); ++k) best[k] = std::min(best[k], run(pairs[k]));
  }
  const auto worst = std::max_element(best.begin(), best.end()) - best.begin();
  state.counters["worst_pair"] = static_cast<double>(worst);
  std::sort(best.begin(), best.end());
  state.counters["median_ms"] = 1e3 * best[best.size() / 2];
  state.counters["p95_ms"] = 1e3 * best[best.size() * 95 / 100];
  state.counters["worst_ms"] = 1e3 * best.back();
}

}  // namespace tandem::bench
