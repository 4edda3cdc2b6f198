#include "surface/refine_section.h"

#include <utility>
#include <vector>

#include "match/second_curve.h"
#include "surface/refine_path.h"

namespace tandem {
inline namespace v0 {
namespace detail {

SectionPath refine_section(const Curve& neighbour, const Curve& section, const SectionPath& path,
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
  refined.correspondence.points = refine(neighbour, second, given, norm, {strain}).points;
  if (c.reversed) {
    for (ParameterPair& point : refined.correspondence.points)
      point.v = c.domain_v.lo + (c.domain_v.hi - point.v);
  }
  return refined;
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
