#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "match/found_match.h"
#include "match/make_report.h"
#include "match/match_along.h"
#include "match/second_curve.h"
#include "match/stopwatch.h"
#include "tandem/curve/compose.h"
#include "tandem/curve/edit.h"
#include "tandem/match/rotation.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

constexpr int kPaperCoefficients = 20;

/// Pins may ask for steeper reparametrisations than matching would find.
constexpr double kPinnedSlope = 1e-6;

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
  Reparametrization r = in_own_domain(
      fit(fit_path(correspondence, found.path.corners), reduction_of(options), correspondence.reversed),
      correspondence.domain_v, b.domain());
  report.seconds.fit = watch.lap();
  Curve curve = compose(second_curve(b, correspondence, r), r.v);
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

}  // namespace

Match finish_match(const Curve& a, const Curve& b, FoundMatch found) {
  if (found.report.cancelled) return cancelled_match(a, b, std::move(found.samples));
  if (found.options.method == Method::elastic) {
    found.report.invalid_nodes = count_invalid_nodes(found.report.path, found.samples.a, found.matched_b,
                                                     found.options, is_closed_layout(found.layout));
  }
  return finish(a, b, found.options, found.layout,
                {std::move(found.samples), std::move(found.path), std::move(found.report)});
}

void follow(FoundMatch& found, Correspondence along) {
  const Samples& b = found.samples.b;
  found.path.corners = corners_of(along, found.samples.a, along.reversed ? reversed(b) : b);
  found.path.correspondence = std::move(along);
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
}  // namespace v0
}  // namespace tandem
