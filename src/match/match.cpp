#include "tandem/match/match.h"

#include <string>
#include <utility>

#include "match/find_rotation.h"
#include "match/found_match.h"
#include "match/make_report.h"
#include "match/match_samples.h"
#include "match/path_correspondence.h"
#include "match/pins.h"
#include "match/sample_pair.h"
#include "match/search.h"
#include "match/search_near.h"
#include "match/segment_paths.h"
#include "match/stopwatch.h"
#include "tandem/error.h"
#include "tandem/match/rotation.h"
#include "tandem/match/segments.h"

namespace tandem {
inline namespace v0 {

namespace {

using detail::FoundMatch;
using detail::Layout;
using detail::MatchSamples;
using detail::PathParameters;
using detail::SamplePair;
using detail::SearchResult;
using detail::Stopwatch;

PathParameters parameters_of(const SamplePair& samples, const SearchResult& found,
                             const MatchOptions& options, Layout layout) {
  return detail::path_parameters(samples.a, found.samples_b, found.path.nodes, found.reversed,
                                 detail::is_closed_layout(layout), options.method == Method::elastic);
}

/// The rotation of a match, and the optimum under it.
struct Optimum {
  Rotation rotation;
  SearchResult found;  ///< samples_b is turned back
};

bool looks_for_turn(const MatchOptions& options) {
  return options.rotation.empty() && options.rotate.value_or(false);
}

/// The optimum for the rotation that the options give, or that has to be found. The coarse samples may be
/// empty where neither a turn is looked for nor coarse_to_fine is wanted.
Optimum find_optimum(const MatchSamples& taken, const MatchOptions& options) {
  const SamplePair& samples = taken.fine;
  const int dim = samples.a.dim();
  Optimum best{options.rotation.empty() ? Rotation(dim) : Rotation(dim, options.rotation), {}};
  const bool look = looks_for_turn(options);
  if (look) {
    const detail::RotationTask task{samples, taken.coarse, taken.layout, taken.plans};
    detail::FoundRotation turn = detail::find_rotation({&task, 1}, options, 0.0);
    best.rotation = std::move(turn.rotation);
    best.found.path.cancelled = turn.cancelled;
    if (!turn.found.empty()) best.found = std::move(turn.found.front());
    if (turn.cancelled || !turn.found.empty()) return best;
  }
  const Rotation back = best.rotation.inverse();
  const SamplePair turned{samples.a, tandem::turned(samples.b, back)};
  if (options.coarse_to_fine) {
    const SamplePair coarse{taken.coarse.a, tandem::turned(taken.coarse.b, back)};
    best.found = detail::search_near(coarse, turned, options, taken.layout, taken.plans.get());
  } else {
    best.found = detail::search(turned.a, turned.b, options, taken.layout, nullptr, taken.plans.get());
  }
  return best;
}

void check_curves(const Curve& a, const Curve& b, const MatchOptions& options) {
  if (a.dim() != b.dim()) {
    throw InvalidArgument("the curves have different dimensions: the first has " + std::to_string(a.dim()) +
                          ", the second " + std::to_string(b.dim()));
  }
  const bool turns = options.rotation.empty() ? options.rotate.value_or(false)
                                              : !Rotation(a.dim(), options.rotation).is_identity();
  if (turns) detail::check_turnable(options.norm);
  for (const int m : options.samples) {
    if (m < 0 || m == 1) throw InvalidArgument("samples must be at least 2, or 0 for the default");
  }
}

FoundMatch cancelled(Layout layout, SamplePair samples) {
  FoundMatch found;
  found.layout = layout;
  found.samples = std::move(samples);
  found.report.cancelled = true;
  return found;
}

FoundMatch match_by_segments(const Curve& a, const Curve& b, MatchOptions options, Layout layout) {
  Stopwatch watch;
  if (options.rotation.empty() && options.rotate.value_or(false)) {
    options.rotation = common_rotation({&a, 1}, {&b, 1}, options).values();
  }
  detail::SegmentPaths paths = detail::segment_paths(a, b, layout, options.pins);
  const double sample_seconds = watch.lap();
  const SegmentMatch found = detail::match_segment_paths(paths, options);
  if (found.cancelled) return cancelled(layout, std::move(paths.samples));
  MatchReport report = detail::make_report(found, a.dim(), options);
  report.seconds.sample = sample_seconds;
  report.seconds.match = watch.lap();
  PathParameters path = detail::path_parameters(found, paths);
  return {std::move(options), layout, std::move(paths.samples), {}, std::move(path), std::move(report)};
}

/// See find_optimum.
FoundMatch match_by_samples(const MatchOptions& options, const MatchSamples& taken, double sample_seconds) {
  Stopwatch watch;
  Optimum best = find_optimum(taken, options);
  const Layout layout = taken.layout;
  SamplePair samples = taken.fine;
  SearchResult& found = best.found;
  if (found.path.cancelled) return cancelled(layout, std::move(samples));
  if (found.path.nodes.empty()) {
    throw InvalidArgument("no path: steps of up to " + std::to_string(options.elastic.longest_step) +
                          " samples cannot match " + std::to_string(samples.a.size()) + " samples with " +
                          std::to_string(samples.b.size()) +
                          "; ask for more equal numbers of samples, or for none");
  }
  PathParameters path = parameters_of(samples, found, options, layout);
  if (!options.pins.empty()) {
    // The paper's paths stand still at corners, which would push the pins aside.
    if (options.method == Method::paper) path.corners.clear();
    detail::keep_pins(path, options.pins);
  }
  MatchReport report = detail::make_report(samples.a, found, options, layout);
  report.rotation = best.rotation.values();
  report.seconds.sample = sample_seconds;
  report.seconds.match = watch.lap();
  return {options,         layout,           std::move(samples), std::move(found.samples_b),
          std::move(path), std::move(report)};
}

}  // namespace

namespace detail {

MatchSamples sample_for_match(const Curve& a, const Curve& b, const MatchOptions& options) {
  check_curves(a, b, options);
  const Layout layout = choose_layout(a, b, options.closed);
  return {sample_pair(a, b, options, layout, 1), sample_pair(a, b, options, layout, kCoarsening), layout};
}

FoundMatch find_match(const Curve& a, const Curve& b, const MatchOptions& options,
                      const MatchSamples& samples) {
  check_curves(a, b, options);
  return match_by_samples(options, samples, 0.0);
}

FoundMatch find_match(const Curve& a, const Curve& b, const MatchOptions& given) {
  check_curves(a, b, given);
  const Layout layout = choose_layout(a, b, given.closed);
  const MatchOptions options = settle_pins(a, b, given, layout);
  if (options.method == Method::segments) return match_by_segments(a, b, options, layout);
  Stopwatch watch;
  MatchSamples samples{sample_pair(a, b, options, layout, 1), {}, layout};
  if (looks_for_turn(options) || options.coarse_to_fine) {
    samples.coarse = sample_pair(a, b, options, layout, kCoarsening);
  }
  return match_by_samples(options, samples, watch.lap());
}

}  // namespace detail

Match match(const Curve& a, const Curve& b, const MatchOptions& options) {
  return detail::finish_match(a, b, detail::find_match(a, b, options));
}

std::vector<Match> match_chain(std::span<const Curve> curves, const MatchOptions& options) {
  if (curves.size() < 2) throw InvalidArgument("a chain needs at least two curves");
  std::vector<Match> matches;
  for (std::size_t k = 0; k + 1 < curves.size(); ++k) {
    matches.push_back(match(k == 0 ? curves[0] : matches.back().curve, curves[k + 1], options));
  }
  return matches;
}

}  // namespace v0
}  // namespace tandem
