#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
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

/// Path data of two drawings.
struct PathPair {
  std::string a;
  std::string b;
};

/// The path data of file_pairs().
[[nodiscard]] std::vector<PathPair> file_paths();

/// The best of a few tries counts for every pair: what it takes when nothing else runs. seconds: of each
/// pair.
inline void report_pairs(benchmark::State& state, std::vector<double> seconds, double unit,
                         const std::string& name) {
  const auto worst = std::max_element(seconds.begin(), seconds.end()) - seconds.begin();
  state.counters["worst_pair"] = static_cast<double>(worst);
  std::sort(seconds.begin(), seconds.end());
  state.counters["median_" + name] = seconds[seconds.size() / 2] / unit;
  state.counters["p95_" + name] = seconds[seconds.size() * 95 / 100] / unit;
  state.counters["worst_" + name] = seconds.back() / unit;
}

/// run(pair) returns seconds.
template <class Pairs, class Run>
void time_pairs(benchmark::State& state, const Pairs& pairs, const Run& run, double unit = 1e-3,
                const std::string& name = "ms") {
  if (pairs.empty()) {
    state.SkipWithError("no pairs: set TANDEM_PAIRS");
    return;
  }
  std::vector<double> best(pairs.size(), 1e9);
  for (auto _ : state) {
    for (std::size_t k = 0; k < pairs.size(); ++k) best[k] = std::min(best[k], run(pairs[k]));
  }
  report_pairs(state, std::move(best), unit, name);
}

}  // namespace tandem::bench
