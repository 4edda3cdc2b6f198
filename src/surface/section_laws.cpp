#include "surface/section_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "match/second_curve.h"
#include "surface/even_speed.h"
#include "surface/law_function.h"
#include "surface/meet_pins.h"
#include "tandem/curve/compose.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Points of a path nearer than this share of the period are one, apart by the rounding of shifted seams.
constexpr double kSamePlace = 1e-10;

std::vector<ParameterPair> pins_between(const SkinOptions& options, std::size_t section) {
  std::vector<ParameterPair> pins;
  for (const std::vector<double>& pin : options.pins) pins.push_back({pin[section], pin[section + 1]});
  return pins;
}

/// The pins as points of the path that the law was fitted to.
std::vector<ParameterPair> pins_on(const FitPath& path, const SectionPath& section) {
  std::vector<ParameterPair> pins;
  const Interval u = section.correspondence.domain_u;
  for (double at : section.pins) {
    if (section.correspondence.closed) at -= std::floor((at - u.lo) / u.length()) * u.length();
    const auto next = std::lower_bound(path.points.begin(), path.points.end(), at,
                                       [](const ParameterPair& p, double x) { return p.u < x; });
    // Matching has put a point at every pin; composed with other paths it may be off by rounding.
    auto nearest = next;
    if (nearest == path.points.end() || (next != path.points.begin() && at - (next - 1)->u < next->u - at)) {
      --nearest;
    }
    pins.push_back(*nearest);
  }
  return pins;
}

/// The correspondence with points at the joints (v), so that a law can be told to meet them.
Correspondence with_points_at(Correspondence c, const std::vector<double>& joints,
                              std::vector<double>& corners) {
  for (const double v : joints) {
    const double u = c.u_at(v);
    const double period = c.domain_u.length();
    const double turns = c.closed ? std::floor((u - c.points.front().u) / period) : 0.0;
    const double along = c.reversed ? -c.domain_v.length() : c.domain_v.length();
    const ParameterPair point{u - turns * period, v - turns * along};
    const double near = kSamePlace * period;
    const auto next = std::lower_bound(c.points.begin(), c.points.end(), point.u - near,
                                       [](const ParameterPair& p, double x) { return p.u < x; });
    if (next != c.points.end() && next->u <= point.u + near) {
      corners.push_back(next->u);
    } else {
      c.points.insert(next, point);
      corners.push_back(point.u);
    }
  }
  return c;
}

/// Largest distance of the law from the path's points, of a step at one u from its nearest point, as a share
/// of v's domain.
double deviation(const Curve& law, const FitPath& path) {
  const LawFunction function(law);
  double most = 0.0;
  for (std::size_t i = 0; i < path.points.size();) {
    std::size_t end = i + 1;
    while (end < path.points.size() && path.points[end].u == path.points[i].u) ++end;
    const double v = function.value(path.points[i].u);
    most = std::max({most, path.points[i].v - v, v - path.points[end - 1].v});
    i = end;
  }
  return most / (path.points.back().v - path.points.front().v);
}

Reparametrization law_of(const SectionPath& section, const Correspondence& c, std::vector<double> corners,
                         const LawOptions& options) {
  const FitPath path = fit_path(c, corners);
  Reparametrization law = smooth_law(path, options, c.closed, c.reversed);
  if (section.pins.empty()) return law;
  if (std::optional<Curve> through = meet_pins(law.v, pins_on(path, section), c.closed)) {
    law.v = *std::move(through);
    return law;
  }
  corners.insert(corners.end(), section.pins.begin(), section.pins.end());
  return smooth_law(fit_path(c, corners), options, c.closed, c.reversed);
}

}  // namespace

SectionPath identity_path(const Curve& first) {
  const Interval u = first.domain();
  return {{{{u.lo, u.lo}, {u.hi, u.hi}}, u, u, first.is_closed(), false}, {}, {}};
}

SectionPath follow(const SectionPath& before, const Match& match) {
  const Correspondence& pair = match.correspondence;
  const Correspondence& first = before.correspondence;
  Correspondence path;
  path.domain_u = first.domain_u;
  path.domain_v = pair.domain_v;
  path.closed = pair.closed;
  path.reversed = first.reversed != pair.reversed;
  path.points.reserve(pair.points.size());
  for (const ParameterPair& point : pair.points) path.points.push_back({first.u_at(point.u), point.v});
  if (first.reversed) std::reverse(path.points.begin(), path.points.end());

  SectionPath result{std::move(path), {}, before.pins};
  // Samples count along the section as it was matched.
  const Samples& nodes = match.samples_b;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes.corners[i]) continue;
    const double v =
        pair.reversed ? nodes.domain.lo + (nodes.domain.hi - nodes.parameters[i]) : nodes.parameters[i];
    result.corners.push_back(result.correspondence.u_at(v));
  }
  return result;
}

std::vector<SectionPath> match_in_sequence(std::span<const Curve> sections, const SkinOptions& options) {
  std::vector<SectionPath> paths{identity_path(sections.front())};
  for (const std::vector<double>& pin : options.pins) paths.front().pins.push_back(pin.front());
  for (std::size_t k = 0; k + 1 < sections.size(); ++k) {
    MatchOptions pair = options.match;
    pair.pins = pins_between(options, k);
    if (options.match.progress) {
      pair.progress = [&options, k, pairs = sections.size() - 1](double fraction) {
        return options.match.progress((static_cast<double>(k) + fraction) / static_cast<double>(pairs));
      };
    }
    // The matched curve is thrown away: a law of few pieces is quickly made.
    if (!pair.reduction) pair.reduction = ReductionOptions{.tolerance = 0.05};
    try {
      const Match found = match(sections[k], sections[k + 1], pair);
      if (found.report.cancelled) return {};
      paths.push_back(follow(paths.back(), found));
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(fmt::format("sections {} and {}: {}", k, k + 1, error.what()));
    }
  }
  return paths;
}

SectionInStep put_in_step(const Curve& section, const SectionPath& path, const LawOptions& options,
                          double corner_angle) {
  std::vector<double> corners = path.corners;
  const Correspondence c = with_points_at(path.correspondence, smooth_joints(section, corner_angle), corners);
  Reparametrization law = law_of(path, c, std::move(corners), options);
  const Curve second = second_curve(section, c, law);
  if (options.order > 2) {
    Curve even = with_even_speed(law.v, second, c.closed, corner_angle);
    const FitPath points = fit_path(c);
    // Pins come first: where both cannot be, the speed may jump.
    if (std::optional<Curve> through = meet_pins(even, pins_on(points, path), c.closed)) {
      law.v = *std::move(through);
      law.max_deviation = deviation(law.v, points);
    }
  }
  return {compose(second, law.v), std::move(law)};
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
