#include "tandem/match/match.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "match/coarse.h"
#include "match/make_report.h"
#include "match/path_correspondence.h"
#include "match/search.h"
#include "tandem/curve/compose.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

namespace {

using detail::Layout;
using detail::PathParameters;
using detail::SearchResult;

constexpr int kOpenSamples = 100;
constexpr int kClosedSamples = 128;
constexpr int kPaperCoefficients = 20;

/// The elastic steps bridge ratios up to the longest step; beyond half of that the default counts are evened
/// out.
constexpr std::size_t kLargestRatio = 3;

/// Coarse to fine: the coarse programme has a quarter of the samples, and the fine one may stray from it by
/// two coarse samples.
constexpr int kCoarsening = 4;
constexpr int kFewestCoarseSamples = 16;
constexpr int kMaskRadius = 2 * kCoarsening;

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

Layout choose_layout(const Curve& a, const Curve& b, ClosedMode mode) {
  const bool both = a.is_closed() && b.is_closed();
  switch (mode) {
    case ClosedMode::no:
      return Layout::open;
    case ClosedMode::yes:
    case ClosedMode::pinned:
      if (!both) {
        throw InvalidArgument(std::string("the ") + (a.is_closed() ? "second" : "first") +
                              " curve is open; matching as loops needs two closed curves");
      }
      return mode == ClosedMode::yes ? Layout::toroidal : Layout::pinned;
    case ClosedMode::automatic:
      break;
  }
  if (both) return Layout::toroidal;
  if (a.is_closed()) return Layout::cut_a;
  return b.is_closed() ? Layout::cut_b : Layout::open;
}

struct SamplePair {
  Samples a;
  Samples b;
};

SampleOptions sample_options(const MatchOptions& options, int requested, bool cyclic, int divisor) {
  const bool paper = options.method == Method::paper;
  SampleOptions s;
  const int count = requested > 0 ? requested : (cyclic && !paper ? kClosedSamples : kOpenSamples);
  s.count = divisor == 1 ? count : std::max(kFewestCoarseSamples, count / divisor);
  s.sampling = options.sampling.value_or(paper ? Sampling::parameter : Sampling::arc);
  s.cyclic = cyclic;
  s.corner_angle = options.corner_angle;
  s.low_pass = options.low_pass;
  return s;
}

/// Errors say which of the two curves they are about.
Samples sample_named(const char* which, const Curve& curve, const SampleOptions& options) {
  try {
    return sample(curve, options);
  } catch (const InvalidArgument& e) {
    throw InvalidArgument(std::string("the ") + which + " curve cannot be sampled: " + e.what());
  }
}

/// Samples of both curves. Counts that the caller left open are raised until the elastic steps can bridge
/// them.
SamplePair sample_pair(const Curve& a, const Curve& b, const MatchOptions& options, Layout layout,
                       int divisor) {
  // The elastic pinned form cuts the second loop against the first one, which is open at its seam.
  const bool pinned_open = layout == Layout::pinned && options.method == Method::elastic;
  const bool cyclic_a =
      layout == Layout::toroidal || layout == Layout::cut_a || (layout == Layout::pinned && !pinned_open);
  const bool cyclic_b = layout == Layout::toroidal || layout == Layout::cut_b || layout == Layout::pinned;
  SampleOptions options_a = sample_options(options, options.samples[0], cyclic_a, divisor);
  SampleOptions options_b = sample_options(options, options.samples[1], cyclic_b, divisor);
  SamplePair pair{sample_named("first", a, options_a), sample_named("second", b, options_b)};
  if (options.method == Method::paper) return pair;
  const auto too_few = [](const Samples& few, const Samples& many) {
    return few.chords() * kLargestRatio < many.chords();
  };
  if (options.samples[0] == 0 && too_few(pair.a, pair.b)) {
    options_a.count = static_cast<int>(pair.b.size() / 2);
    pair.a = sample(a, options_a);
  } else if (options.samples[1] == 0 && too_few(pair.b, pair.a)) {
    options_b.count = static_cast<int>(pair.a.size() / 2);
    pair.b = sample(b, options_b);
  }
  return pair;
}

PathParameters parameters_of(const SamplePair& samples, const SearchResult& found,
                             const MatchOptions& options, Layout layout) {
  return detail::path_parameters(samples.a, found.samples_b, found.path.nodes, found.reversed,
                                 detail::is_closed_layout(layout), options.method == Method::elastic);
}

/// The programme on a quarter of the samples, and with it a mask for all of them; also settles the direction.
NodeMask coarse_mask(const Curve& a, const Curve& b, const SamplePair& fine, MatchOptions& options,
                     Layout layout) {
  const SamplePair coarse = sample_pair(a, b, options, layout, kCoarsening);
  const SearchResult found = detail::search(coarse.a, coarse.b, options, layout);
  if (found.path.nodes.empty() || found.path.cancelled) return {};
  options.direction = found.reversed ? Direction::reversed : Direction::forward;
  return detail::mask_near(fine.a, fine.b, parameters_of(coarse, found, options, layout).correspondence,
                           kMaskRadius);
}

ReductionOptions reduction_of(const MatchOptions& options) {
  if (options.reduction) return *options.reduction;
  ReductionOptions reduction;
  if (options.method == Method::paper) reduction.coefficients = kPaperCoefficients;
  return reduction;
}

/// The second curve as v(u) refers to it: cut, turned round, and with its seam where v begins.
Curve prepare_second(const Curve& b, const Correspondence& c, const Reparametrization& r, Layout layout) {
  Curve curve = layout == Layout::cut_b ? move_seam(b, c.domain_v.lo) : b;
  if (r.reversed) {
    // t -> lo + hi - t in the curve's own domain, wherever it was cut.
    const double sum = b.domain().lo + b.domain().hi;
    const Interval cut = curve.domain();
    curve = with_domain(reverse(curve), {sum - cut.hi, sum - cut.lo});
  }
  if (detail::is_closed_layout(layout)) curve = move_seam(curve, r.v.control_points().front()[0]);
  return curve;
}

/// The fit turns v round in the correspondence's domain; v is to refer to the reversed second curve in its
/// own, which differs when a loop was cut.
Reparametrization in_own_domain(Reparametrization r, const Interval& cut, const Interval& own) {
  const double offset = (own.lo + own.hi) - (cut.lo + cut.hi);
  if (!r.reversed || offset == 0.0) return r;
  Points points = r.v.control_points();
  for (double& v : points.data()) v += offset;
  r.v = Curve(r.v.degree(), r.v.knots(), std::move(points));
  return r;
}

NormKind validity_norm(const Norm& norm) {
  const auto* kind = std::get_if<NormKind>(&norm);
  return kind != nullptr && *kind == NormKind::ruled ? NormKind::ruled : NormKind::tangent;
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
  for (const int m : options.samples) {
    if (m < 0 || m == 1) throw InvalidArgument("samples must be at least 2, or 0 for the default");
  }
}

}  // namespace

Match match(const Curve& a, const Curve& b, const MatchOptions& given) {
  check_curves(a, b, given);
  MatchOptions options = given;
  const Layout layout = choose_layout(a, b, options.closed);
  Stopwatch watch;
  SamplePair samples = sample_pair(a, b, options, layout, 1);
  const double sample_seconds = watch.lap();

  NodeMask mask;
  if (options.coarse_to_fine) mask = coarse_mask(a, b, samples, options, layout);
  SearchResult found = detail::search(samples.a, samples.b, options, layout, mask);
  if (found.path.nodes.empty() && !mask.allowed.empty() && !found.path.cancelled) {
    found = detail::search(samples.a, samples.b, options, layout);
  }
  if (found.path.cancelled) return cancelled_match(a, b, std::move(samples));
  if (found.path.nodes.empty()) {
    throw InvalidArgument("no path: steps of up to " + std::to_string(options.elastic.longest_step) +
                          " samples cannot match " + std::to_string(samples.a.size()) + " samples with " +
                          std::to_string(samples.b.size()) +
                          "; ask for more equal numbers of samples, or for none");
  }
  PathParameters path = parameters_of(samples, found, options, layout);
  MatchReport report = detail::make_report(samples.a, found, options, layout);
  report.seconds.sample = sample_seconds;
  report.seconds.match = watch.lap();

  Reparametrization r = in_own_domain(
      fit(fit_path(path.correspondence, path.corners), reduction_of(options), path.correspondence.reversed),
      path.correspondence.domain_v, b.domain());
  report.seconds.fit = watch.lap();
  Curve curve = compose(prepare_second(b, path.correspondence, r, layout), r.v);
  report.seconds.compose = watch.lap();

  const Curve& first = layout == Layout::cut_a ? move_seam(a, curve.domain().lo) : a;
  report.validity = check_validity(first, curve, validity_norm(options.norm));
  return {
      std::move(path.correspondence), std::move(r), std::move(curve), std::move(report), std::move(samples.a),
      std::move(found.samples_b)};
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
