#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tandem/curve/compose.h"
#include "tandem/match/elastic.h"
#include "tandem/match/match.h"

namespace {

using namespace tandem;

/// An open cubic B-spline with `n` control points, or a periodic one.
Curve wander(unsigned seed, std::size_t n, bool closed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double lo, double hi) { return lo + (hi - lo) * (random() / 4294967296.0); };
  Points points(2, n);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
    const double radius = 1.0 + uniform(-0.3, 0.3);
    points[i][0] = closed ? radius * std::cos(angle) : static_cast<double>(i) + uniform(-0.5, 0.5);
    points[i][1] = closed ? radius * std::sin(angle) : uniform(-2.0, 2.0);
  }
  if (!closed) return Curve::clamped_uniform(3, std::move(points));
  for (std::size_t i = 0; i < 3; ++i)
    points.push_back(std::vector<double>(points[i].begin(), points[i].end()));
  std::vector<double> knots;
  for (std::size_t k = 0; k < n + 7; ++k)
    knots.push_back((static_cast<double>(k) - 3.0) / static_cast<double>(n));
  return Curve(3, std::move(knots), std::move(points));
}

/// The yardstick: [C] eq. (7) in plain doubles, row by row, with 2m for invalid nodes and a path.
double plain_programme(const NodeTable& t, std::vector<double>& cost, std::vector<Node>& path) {
  const std::size_t m = t.rows;
  const std::size_t n = t.cols;
  const double penalty = static_cast<double>(m + n);
  cost.resize(m * n);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      double best = i + j == 0 ? 0.0 : std::numeric_limits<double>::infinity();
      if (i > 0 && j > 0) best = cost[(i - 1) * n + j - 1];
      if (j > 0) best = std::min(best, cost[i * n + j - 1]);
      if (i > 0) best = std::min(best, cost[(i - 1) * n + j]);
      cost[i * n + j] = best + (t.invalid[i * n + j] != 0 ? penalty : t.cost[i * n + j]);
    }
  }
  path.clear();
  for (std::size_t i = m - 1, j = n - 1;;) {
    path.push_back({static_cast<int>(i), static_cast<int>(j)});
    if (i + j == 0) break;
    const double diagonal =
        i > 0 && j > 0 ? cost[(i - 1) * n + j - 1] : std::numeric_limits<double>::infinity();
    const double left = j > 0 ? cost[i * n + j - 1] : std::numeric_limits<double>::infinity();
    const double up = i > 0 ? cost[(i - 1) * n + j] : std::numeric_limits<double>::infinity();
    if (diagonal <= left && diagonal <= up) {
      --i;
      --j;
    } else if (left <= up) {
      --j;
    } else {
      --i;
    }
  }
  return cost.back();
}

SampleOptions paper_samples(int m) {
  return {.count = m, .sampling = Sampling::parameter};
}

void BM_yardstick_plain_programme(benchmark::State& state) {
  const int m = static_cast<int>(state.range(0));
  const NodeTable t = node_costs(sample(wander(1, 40, false), paper_samples(m)),
                                 sample(wander(2, 40, false), paper_samples(m)), NormKind::tangent);
  std::vector<double> cost;
  std::vector<Node> path;
  for (auto _ : state) benchmark::DoNotOptimize(plain_programme(t, cost, path));
}
BENCHMARK(BM_yardstick_plain_programme)->Arg(100)->Arg(300)->Arg(1000);

void BM_three_step_programme(benchmark::State& state) {
  const int m = static_cast<int>(state.range(0));
  const NodeTable t = node_costs(sample(wander(1, 40, false), paper_samples(m)),
                                 sample(wander(2, 40, false), paper_samples(m)), NormKind::tangent);
  for (auto _ : state) benchmark::DoNotOptimize(open_path(t));
}
BENCHMARK(BM_three_step_programme)->Arg(100)->Arg(300)->Arg(1000);

void BM_paper_sample_two_curves(benchmark::State& state) {
  const Curve a = wander(1, 40, false);
  const Curve b = wander(2, 40, false);
  for (auto _ : state) {
    benchmark::DoNotOptimize(sample(a, paper_samples(100)));
    benchmark::DoNotOptimize(sample(b, paper_samples(100)));
  }
}
BENCHMARK(BM_paper_sample_two_curves);

/// [C] on open curves: sampling, costs, programme, fit and composition, m = 100, 20 coefficients. One
/// direction.
void BM_paper_open_whole(benchmark::State& state) {
  const Curve a = wander(1, 40, false);
  const Curve b = wander(2, 40, false);
  const MatchOptions options{.method = Method::paper, .direction = Direction::forward, .threads = 1};
  double sample_seconds = 0.0;
  double match_seconds = 0.0;
  double fit_seconds = 0.0;
  double compose_seconds = 0.0;
  for (auto _ : state) {
    const Match m = match(a, b, options);
    sample_seconds += m.report.seconds.sample;
    match_seconds += m.report.seconds.match;
    fit_seconds += m.report.seconds.fit;
    compose_seconds += m.report.seconds.compose;
  }
  const double to_us = 1e6 / static_cast<double>(state.iterations());
  state.counters["sample_us"] = sample_seconds * to_us;
  state.counters["match_us"] = match_seconds * to_us;
  state.counters["fit_us"] = fit_seconds * to_us;
  state.counters["compose_us"] = compose_seconds * to_us;
  // Without the re-check of the fitted curves' validity, which `time` contains.
  state.counters["stages_us"] = (sample_seconds + match_seconds + fit_seconds + compose_seconds) * to_us;
}
BENCHMARK(BM_paper_open_whole);

void BM_elastic_open(benchmark::State& state) {
  const Curve a = wander(1, 40, false);
  const Curve b = wander(2, 40, false);
  MatchOptions options{.samples = {static_cast<int>(state.range(0)), static_cast<int>(state.range(0))},
                       .direction = state.range(1) != 0 ? Direction::automatic : Direction::forward,
                       .threads = 1};
  for (auto _ : state) benchmark::DoNotOptimize(match(a, b, options));
}
BENCHMARK(BM_elastic_open)->ArgNames({"m", "both_directions"})->Args({100, 0})->Args({100, 1});

void BM_closed(benchmark::State& state) {
  const Curve a = wander(1, 40, true);
  const Curve b = wander(2, 40, true);
  MatchOptions options{.method = state.range(0) != 0 ? Method::elastic : Method::paper, .threads = 1};
  for (auto _ : state) benchmark::DoNotOptimize(match(a, b, options));
}
BENCHMARK(BM_closed)->ArgNames({"elastic"})->Args({0})->Args({1});

}  // namespace
