#include "tandem/match/match.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "match/find_rotation.h"
#include "match/make_report.h"
#include "match/match_along.h"
#include "match/match_samples.h"
#include "match/path_correspondence.h"
#include "match/pins.h"
#include "match/sample_pair.h"
#include "match/search.h"
#include "match/search_near.h"
#include "match/second_curve.h"
#include "match/segment_paths.h"
#include "tandem/curve/compose.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/match/rotation.h"
#include "tandem/match/segments.h"

namespace tandem {
inline namespace v0 {

namespace {

using detail::Layout;
using detail::MatchSamples;
using detail::PathParameters;
using detail::SamplePair;
using detail::SearchResult;

constexpr int kPaperCoefficients = 20;

/// Pins may ask for steeper reparametrisations than matching would find.
constexpr double kPinnedSlope = 1e-6;

class Stopwatch {
 public:
  /// Seconds since construction or the last lap.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

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

ReductionOptions reduction_of(const MatchOptions& options) {
  if (options.reduction) return *options.reduction;
  ReductionOptions reduction;
  if (!options.pins.empty()) {
    reduction.min_slope = kPinnedSlope;
  } else if (options.method == Method::paper) {
    reduction.coefficients = kPaperCoefficients;
  }
  return reduction;
}

/// The curve turned about the origin, and halved, so that huge coordinates stay finite: what validity in the
/// tangent norm depends on stays the same.
Curve turned(const Curve& curve, const Rotation& rotation) {
  Points points = curve.control_points();
  for (double& x : points.data()) x *= 0.5;
  return Curve(curve.degree(), curve.knots(), rotation(std::move(points)), curve.weights());
}

/// [C] Definition 5 in the frame in which the blend is made (spec C5): the second curve turned back.
Validity validity_of(const Curve& a, const Curve& b, const Rotation& rotation, const Norm& norm) {
  const auto* kind = std::get_if<NormKind>(&norm);
  if (kind != nullptr && *kind == NormKind::ruled) return check_validity(a, b, NormKind::ruled);
  return check_validity(a, rotation.is_identity() ? b : turned(b, rotation.inverse()), NormKind::tangent);
}

/// What a cancelled match holds: the curves side by side by their parameters.
Match cancelled_match(const Curve& a, const Curve& b, SamplePair samples) {
  const Interval u = a.domain();
  const Interval v = b.domain();
  Correspondence c{{{u.lo, v.lo}, {u.hi, v.hi}}, u, v, false, false};
  Reparametrization r = fit({c.points, {}}, {});
  MatchReport report;
  report.cancelled = true;
  return {std::move(c),      std::move(r),         with_domain(b, u),
          std::move(report), std::move(samples.a), std::move(samples.b)};
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

/// What is known once the path is.
struct Found {
  SamplePair samples;  ///< both forward
  PathParameters path;
  MatchReport report;  ///< all but the fit and what follows it
};

// Where a point of the correspondence lies in a corner of either curve, within this share of its domain.
constexpr double kAtCorner = 1e-6;

std::vector<double> corners_of(const Correspondence& c, const Samples& a, const Samples& b) {
  const auto in_corner = [](const Samples& samples, double at) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (!samples.corners[i]) continue;
      const double off = samples.parameters[i] - at;
      const double period = samples.domain.length();
      const double least = samples.cyclic ? std::remainder(off, period) : off;
      if (std::fabs(least) <= kAtCorner * period) return true;
    }
    return false;
  };
  std::vector<double> corners;
  for (const ParameterPair& p : c.points) {
    const double v = c.reversed ? b.domain.lo + (b.domain.hi - p.v) : p.v;
    if (!in_corner(a, p.u) && !in_corner(b, v)) continue;
    corners.push_back(c.closed && p.u >= c.domain_u.hi ? p.u - c.domain_u.length() : p.u);
  }
  return corners;
}

/// From the path to curves in step.
Match finish(const Curve& a, const Curve& b, const MatchOptions& options, Layout layout, Found found) {
  Stopwatch watch;
  const Correspondence& correspondence = found.path.correspondence;
  MatchReport& report = found.report;
  Reparametrization r = detail::in_own_domain(
      fit(fit_path(correspondence, found.path.corners), reduction_of(options), correspondence.reversed),
      correspondence.domain_v, b.domain());
  report.seconds.fit = watch.lap();
  Curve curve = compose(detail::second_curve(b, correspondence, r), r.v);
  report.seconds.compose = watch.lap();

  const Curve& first = layout == Layout::cut_a ? move_seam(a, curve.domain().lo) : a;
  report.validity = validity_of(first, curve, Rotation(a.dim(), report.rotation), options.norm);
  if (correspondence.reversed) found.samples.b = reversed(found.samples.b);
  return {std::move(found.path.correspondence),
          std::move(r),
          std::move(curve),
          std::move(found.report),
          std::move(found.samples.a),
          std::move(found.samples.b)};
}

Match match_by_segments(const Curve& a, const Curve& b, MatchOptions options, Layout layout) {
  Stopwatch watch;
  if (options.rotation.empty() && options.rotate.value_or(false)) {
    options.rotation = common_rotation({&a, 1}, {&b, 1}, options).values();
  }
  detail::SegmentPaths paths = detail::segment_paths(a, b, layout, options.pins);
  const double sample_seconds = watch.lap();
  const SegmentMatch found = detail::match_segment_paths(paths, options);
  if (found.cancelled) return cancelled_match(a, b, std::move(paths.samples));
  MatchReport report = detail::make_report(found, a.dim(), options);
  report.seconds.sample = sample_seconds;
  report.seconds.match = watch.lap();
  PathParameters path = detail::path_parameters(found, paths);
  return finish(a, b, options, layout, {std::move(paths.samples), std::move(path), std::move(report)});
}

/// From samples to curves in step; see find_optimum.
Match match_by_samples(const Curve& a, const Curve& b, const MatchOptions& options, const MatchSamples& taken,
                       double sample_seconds) {
  Stopwatch watch;
  const Optimum best = find_optimum(taken, options);
  const Layout layout = taken.layout;
  SamplePair samples = taken.fine;
  const SearchResult& found = best.found;
  if (found.path.cancelled) return cancelled_match(a, b, std::move(samples));
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
  return finish(a, b, options, layout, {std::move(samples), std::move(path), std::move(report)});
}

}  // namespace

namespace detail {

MatchSamples sample_for_match(const Curve& a, const Curve& b, const MatchOptions& options) {
  check_curves(a, b, options);
  const Layout layout = choose_layout(a, b, options.closed);
  return {sample_pair(a, b, options, layout, 1), sample_pair(a, b, options, layout, kCoarsening), layout};
}

Match match_sampled(const Curve& a, const Curve& b, const MatchOptions& options,
                    const MatchSamples& samples) {
  check_curves(a, b, options);
  return match_by_samples(a, b, options, samples, 0.0);
}

Match match_along(const Curve& a, const Curve& b, const MatchOptions& options, Match found,
                  Correspondence along) {
  const Layout layout = choose_layout(a, b, options.closed);
  std::vector<double> corners = corners_of(along, found.samples_a, found.samples_b);
  SamplePair samples{std::move(found.samples_a), std::move(found.samples_b)};
  if (along.reversed) samples.b = reversed(samples.b);
  return finish(a, b, options, layout,
                {std::move(samples), {std::move(along), std::move(corners)}, std::move(found.report)});
}

Match inverse_match(const Curve& a, const Curve& b, const MatchOptions& options, Match found) {
  MatchReport& report = found.report;
  const bool turned_round = found.correspondence.reversed;
  std::swap(found.samples_a, found.samples_b);
  if (turned_round) {  // the second ones run backwards
    found.samples_a = reversed(found.samples_a);
    found.samples_b = reversed(found.samples_b);
  }
  std::swap(report.samples[0], report.samples[1]);
  for (Node& node : report.path) {
    node = turned_round ? Node{report.samples[0] - 1 - node.j, report.samples[1] - 1 - node.i}
                        : Node{node.j, node.i};
  }
  if (turned_round) std::reverse(report.path.begin(), report.path.end());
  if (!report.path.empty() && found.correspondence.closed) {
    report.shift = shift_of(report.path.front(), report.samples[0], report.samples[1]);
  }
  report.rotation = Rotation(a.dim(), report.rotation).inverse().values();
  Correspondence along = found.correspondence.inverse();
  return match_along(b, a, options, std::move(found), std::move(along));
}

}  // namespace detail

Match match(const Curve& a, const Curve& b, const MatchOptions& given) {
  check_curves(a, b, given);
  const Layout layout = detail::choose_layout(a, b, given.closed);
  const MatchOptions options = detail::settle_pins(a, b, given, layout);
  if (options.method == Method::segments) return match_by_segments(a, b, options, layout);
  Stopwatch watch;
  MatchSamples samples{detail::sample_pair(a, b, options, layout, 1), {}, layout};
  if (looks_for_turn(options) || options.coarse_to_fine) {
    samples.coarse = detail::sample_pair(a, b, options, layout, detail::kCoarsening);
  }
  return match_by_samples(a, b, options, samples, watch.lap());
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
