#include "tandem/surface/skin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "surface/section_laws.h"
#include "surface/skin_report.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::SectionInStep;
using detail::SectionPath;

void check(std::span<const Curve> sections, const SkinOptions& options) {
  for (std::size_t k = 0; k < options.pins.size(); ++k) {
    if (options.pins[k].size() == sections.size()) continue;
    throw InvalidArgument(fmt::format("pin {} has {} parameters for {} sections, expected one each", k,
                                      options.pins[k].size(), sections.size()));
  }
  if (!(options.law_tolerance > 0.0)) {
    throw InvalidArgument(fmt::format("the laws' tolerance is {}, expected > 0", options.law_tolerance));
  }
}

struct InStep {
  std::vector<Curve> sections;
  std::vector<Reparametrization> laws;
};

InStep put_in_step(std::span<const Curve> sections, const std::vector<SectionPath>& paths, double tolerance) {
  InStep all{{sections.front()}, {}};
  const Interval u = sections.front().domain();
  all.laws.push_back({Curve::bezier(Points(1, {u.lo, u.hi}), {}, u), 0.0, false});
  for (std::size_t k = 1; k < sections.size(); ++k) {
    SectionInStep next = detail::put_in_step(sections[k], paths[k], tolerance);
    all.sections.push_back(std::move(next.curve));
    all.laws.push_back(std::move(next.law));
  }
  return all;
}

SkinReport report_on(const InStep& all, const std::vector<SectionPath>& paths, const Loft& made,
                     const SkinOptions& options) {
  SkinReport report;
  const bool ring = options.loft.closed;
  const std::vector<double> costs = detail::pair_costs(all.sections, options.match.elastic.lambda, ring);
  const auto* kind = std::get_if<NormKind>(&options.match.norm);
  report.valid = true;
  for (std::size_t k = 0; k < costs.size(); ++k) {
    const std::size_t next = (k + 1) % all.sections.size();
    SkinPair pair;
    pair.validity = check_validity(all.sections[k], all.sections[next], kind == nullptr ? NormKind::tangent : *kind);
    pair.cost = costs[k];
    pair.direction = paths[k].correspondence.reversed == paths[next].correspondence.reversed
                         ? Direction::forward
                         : Direction::reversed;
    report.valid = report.valid && pair.validity.valid;
    report.total_cost += pair.cost;
    report.pairs.push_back(pair);
  }
  for (const Reparametrization& law : all.laws) {
    report.law_deviation = std::max(report.law_deviation, law.max_deviation);
  }
  report.crease_angle =
      detail::crease_angle(made.surface, all.sections, made.parameters, options.match.corner_angle);
  report.interpolation_error = detail::interpolation_error(made.surface, all.sections, made.parameters);
  return report;
}

}  // namespace

SkinnedSurface skin(std::span<const Curve> sections, const SkinOptions& options) {
  check(sections, options);
  const std::vector<SectionPath> paths = detail::match_in_sequence(sections, options);
  InStep all = put_in_step(sections, paths, options.law_tolerance);
  Loft made = loft(all.sections, options.loft);
  SkinReport report = report_on(all, paths, made, options);
  report.sequence_cost = report.total_cost;
  return {std::move(made.surface), std::move(made.parameters), std::move(all.sections), std::move(all.laws),
          std::move(report)};
}

}  // namespace v0
}  // namespace tandem
