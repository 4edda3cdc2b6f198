#include "surface/refine_section.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "match/second_curve.h"
#include "surface/law_function.h"
#include "surface/refine_path.h"
#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Polylines along laws are within a 2000th of what a law turns by in a span.
constexpr int kPlacesPerSpan = 16;

template <class Map>
FitPath mapped(FitPath path, const Map& map) {
  for (ParameterPair& point : path.points) point.u = map(point.u);
  for (double& corner : path.corner_parameters) corner = map(corner);
  return path;
}

}  // namespace

SectionPath refine_section(const Neighbour& neighbour, const Curve& section, const SectionPath& path,
                           const RailNorm& norm, double strain, bool along_neighbour) {
  const Correspondence& c = path.correspondence;
  std::vector<double> fixed = path.corners;
  fixed.insert(fixed.end(), path.pins.begin(), path.pins.end());
  const FitPath given = fit_path(c, fixed);
  // Any law of this path: it only says where the section begins, and which way it runs.
  const Reparametrization law = fit(given, {}, c.reversed);
  const Curve second = second_curve(section, c, in_own_domain(law, c.domain_v, section.domain()));
  SectionPath refined = path;
  const auto& refine = along_neighbour ? refine_path_along_first : refine_path;
  const LawFunction along(neighbour.law);
  refined.correspondence.points =
      refine(neighbour.curve, second, mapped(given, [&](double u) { return along.value(u); }), norm, {strain})
          .points;
  for (ParameterPair& point : refined.correspondence.points) point.u = along.parameter(point.u);
  if (c.reversed) {
    for (ParameterPair& point : refined.correspondence.points)
      point.v = c.domain_v.lo + (c.domain_v.hi - point.v);
  }
  return refined;
}

Correspondence as_correspondence(const Reparametrization& law, const Correspondence& like,
                                 std::span<const double> exact) {
  const Interval u = law.v.domain();
  std::vector<double> places;
  for (const double at : exact)
    places.push_back(like.closed ? at - std::floor((at - u.lo) / u.length()) * u.length() : u.clamp(at));
  const std::vector<Knot> knots = distinct_knots(law.v.knots());
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    for (int k = 0; k < kPlacesPerSpan; ++k) {
      const double share = static_cast<double>(k) / kPlacesPerSpan;
      places.push_back((1.0 - share) * knots[i].value + share * knots[i + 1].value);
    }
  }
  places.push_back(knots.back().value);
  std::sort(places.begin(), places.end());
  const LawFunction along(law.v);
  Correspondence result = like;
  result.points.clear();
  for (const double at : places) {
    const double v = along.value(at);
    result.points.push_back({at, like.reversed ? like.domain_v.lo + (like.domain_v.hi - v) : v});
  }
  return result;
}

SectionPath carry_over(const SectionPath& later, const Correspondence& before,
                       const Correspondence& changed) {
  const auto moved = [&](double u) { return changed.u_at(before.v_at(u)); };
  SectionPath result = later;
  for (ParameterPair& point : result.correspondence.points) point.u = moved(point.u);
  for (double& corner : result.corners) corner = moved(corner);
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
