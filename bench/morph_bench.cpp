#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <ctime>
#include <map>
#include <utility>
#include <vector>

#include "curve_pairs.h"
#include "tandem/io/path_data.h"
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

const std::vector<Shape>& stars() {
  static const std::vector<Shape> keys{star(5, 4.0), star(8, 7.0)};
  return keys;
}

const Morph& morph() {
  static const Morph result(stars());
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
  const PathMorph paths(stars());
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
  const PathMorph paths(stars());
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

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

PathMorph morph_of(const bench::PathPair& pair, const MorphOptions& options) {
  const std::vector<Shape> keys{to_shape(parse_path_data(pair.a)), to_shape(parse_path_data(pair.b))};
  return PathMorph(keys, options);
}

/// Everything from two path strings to a ready morph, on one thread: turns, ways of matching, blends and the
/// looks at their in-betweens.
void BM_PathMorph_file(benchmark::State& state) {
  MorphOptions options;
  options.match.threads = 1;
  options.match.coarse_to_fine = state.range(0) != 0;
  bench::time_pairs(state, bench::file_paths(), [&](const bench::PathPair& pair) {
    const double start = cpu_seconds();
    benchmark::DoNotOptimize(morph_of(pair, options));
    return cpu_seconds() - start;
  });
}
BENCHMARK(BM_PathMorph_file)->ArgName("fast")->Arg(0)->Arg(1)->Iterations(3)->Unit(benchmark::kMillisecond);

/// Morphs of every fifth pair in one blend; detours are those pairs' that take one.
const std::vector<PathMorph>& file_morphs(BlendKind kind) {
  static std::map<BlendKind, std::vector<PathMorph>> all;
  std::vector<PathMorph>& morphs = all[kind];
  if (!morphs.empty()) return morphs;
  MorphOptions options;
  options.blend = kind;
  const std::vector<bench::PathPair> pairs = bench::file_paths();
  for (std::size_t k = 0; k < pairs.size(); k += 5) {
    PathMorph made = morph_of(pairs[k], options);
    if (kind != BlendKind::detour || made.steps().front().detour) morphs.push_back(std::move(made));
  }
  return morphs;
}

/// Times frame(s) in microseconds.
template <class MakeFrame>
void time_frames(benchmark::State& state, const MakeFrame& make_frame) {
  constexpr int kRounds = 20;
  constexpr int kFrames = 10;
  bench::time_pairs(
      state, file_morphs(static_cast<BlendKind>(state.range(0))),
      [&](const PathMorph& morph) {
        auto frame = make_frame(morph);
        const double start = cpu_seconds();
        for (int k = 0; k < kRounds * kFrames; ++k) frame((k % kFrames + 0.5) / kFrames);
        return (cpu_seconds() - start) / (kRounds * kFrames);
      },
      1e-6, "us");
}

/// One in-between into the caller's memory.
void BM_PathMorph_frame(benchmark::State& state) {
  time_frames(state, [](const PathMorph& morph) {
    return [&morph, points = std::vector<double>(morph.coordinate_count())](double s) mutable {
      morph.at(s, points);
      benchmark::DoNotOptimize(points.data());
    };
  });
}

/// The same as path data of three decimals.
void BM_PathMorph_string(benchmark::State& state) {
  time_frames(state, [](const PathMorph& morph) {
    return [write = PathDataWriter(morph, 3)](double s) mutable { benchmark::DoNotOptimize(write(s)); };
  });
}

void all_blends(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("blend")->Iterations(20)->Unit(benchmark::kMillisecond);
  for (const BlendKind kind :
       {BlendKind::affine, BlendKind::hermite, BlendKind::intrinsic, BlendKind::detour}) {
    benchmark->Arg(static_cast<int>(kind));
  }
}
BENCHMARK(BM_PathMorph_frame)->Apply(all_blends);
BENCHMARK(BM_PathMorph_string)->Apply(all_blends);

}  // namespace
