#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "tandem/match/reparametrization.h"

namespace tandem {
inline namespace v0 {
namespace {

/// Parameters this close, as a share of the domain, are the same: a thousandth of the 1e-9 within which ends
/// of closed curves meet, and far above the rounding of a parameter that was shifted by a period.
constexpr double kSameParameter = 1e-12;

/// kSameParameter of the domain, but no less than what doubles of this size can tell apart.
double same_within(const Interval& domain) {
  const double size = std::max(std::abs(domain.lo), std::abs(domain.hi));
  return std::max(kSameParameter * domain.length(), 4.0 * std::numeric_limits<double>::epsilon() * size);
}

/// lo + hi - v, exact at the ends.
double turned(const Interval& domain, double v) {
  if (v == domain.lo) return domain.hi;
  if (v == domain.hi) return domain.lo;
  return domain.lo + (domain.hi - v);
}

std::vector<ParameterPair> with_rising_v(const Correspondence& correspondence) {
  std::vector<ParameterPair> points = correspondence.points;
  if (correspondence.reversed) {
    for (ParameterPair& point : points) point.v = turned(correspondence.domain_v, point.v);
  }
  return points;
}

std::vector<ParameterPair> open_points(const Correspondence& correspondence) {
  const Interval& domain = correspondence.domain_u;
  std::vector<ParameterPair> points = with_rising_v(correspondence);
  const double same = same_within(domain);
  for (ParameterPair& point : points) {
    point.u = domain.clamp(point.u);
    point.v = correspondence.domain_v.clamp(point.v);
    if (point.u - domain.lo <= same) point.u = domain.lo;
    if (domain.hi - point.u <= same) point.u = domain.hi;
  }
  if (points.empty()) return points;
  if (points.front().u > domain.lo) points.insert(points.begin(), {domain.lo, points.front().v});
  if (points.back().u < domain.hi) points.push_back({domain.hi, points.back().v});
  return points;
}

/// The distinct points of a closed path, shifted by whole periods so that domain.lo <= u < domain.hi, in
/// order.
std::vector<ParameterPair> one_period(const Correspondence& correspondence) {
  const Interval& domain = correspondence.domain_u;
  const double period_v = correspondence.domain_v.length();
  const double same = same_within(domain);
  std::vector<ParameterPair> points = with_rising_v(correspondence);
  if (points.size() > 1) points.pop_back();

  std::size_t start = 0;
  double previous = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double periods = std::floor((points[i].u - domain.lo) / domain.length());
    double u = points[i].u - periods * domain.length();
    if (domain.hi - u <= same) {
      periods += 1.0;
      u = domain.lo;
    }
    points[i] = {u - domain.lo <= same ? domain.lo : u, points[i].v - periods * period_v};
    if (i > 0 && periods > previous) start = i;
    previous = periods;
  }
  std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(start), points.end());
  return points;
}

std::vector<ParameterPair> closed_points(const Correspondence& correspondence) {
  const Interval& domain = correspondence.domain_u;
  const double period_v = correspondence.domain_v.length();
  std::vector<ParameterPair> cycle = one_period(correspondence);
  if (cycle.empty()) return cycle;

  // v at the cut: half-way along the points that lie on it, else between the last point and the first one.
  std::size_t on_cut = 0;
  while (on_cut < cycle.size() && cycle[on_cut].u == domain.lo) ++on_cut;
  double v_cut = cycle.front().v;
  if (on_cut > 1) {
    v_cut = 0.5 * cycle.front().v + 0.5 * cycle[on_cut - 1].v;
  } else if (on_cut == 0) {
    const double before = domain.hi - cycle.back().u;
    const double share = before / (before + (cycle.front().u - domain.lo));
    v_cut = (1.0 - share) * (cycle.back().v - period_v) + share * cycle.front().v;
  }

  std::vector<ParameterPair> points;
  points.reserve(cycle.size() + 2);
  points.push_back({domain.lo, v_cut});
  for (const ParameterPair& point : cycle) {
    if (point.u > domain.lo || point.v > v_cut) points.push_back(point);
  }
  for (std::size_t i = 0; i < on_cut; ++i) {
    if (cycle[i].v < v_cut) points.push_back({domain.hi, cycle[i].v + period_v});
  }
  points.push_back({domain.hi, v_cut + period_v});
  return points;
}

/// Rounding of shifted parameters must not make the path step back, nor past its own end.
void keep_monotone(std::vector<ParameterPair>& points) {
  if (points.empty()) return;
  const Interval rise{points.front().v, points.back().v};
  for (std::size_t i = 1; i < points.size(); ++i) {
    points[i].u = std::max(points[i].u, points[i - 1].u);
    points[i].v = std::max(rise.clamp(points[i].v), points[i - 1].v);
  }
}

}  // namespace

FitPath fit_path(const Correspondence& correspondence, std::span<const double> corners) {
  FitPath path;
  path.points = correspondence.closed ? closed_points(correspondence) : open_points(correspondence);
  keep_monotone(path.points);

  const Interval& domain = correspondence.domain_u;
  const double same = same_within(domain);
  for (double corner : corners) {
    if (correspondence.closed) corner -= std::floor((corner - domain.lo) / domain.length()) * domain.length();
    const auto after = std::lower_bound(path.points.begin(), path.points.end(), corner - same,
                                        [](const ParameterPair& point, double u) { return point.u < u; });
    if (after != path.points.end() && after->u <= corner + same) path.corner_parameters.push_back(after->u);
  }
  std::vector<double>& found = path.corner_parameters;
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return path;
}

}  // namespace v0
}  // namespace tandem
