#include "surface/section_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "surface/smooth_law.h"
#include "tandem/curve/compose.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

std::vector<ParameterPair> pins_between(const SkinOptions& options, std::size_t section) {
  std::vector<ParameterPair> pins;
  for (const std::vector<double>& pin : options.pins) pins.push_back({pin[section], pin[section + 1]});
  return pins;
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
    const double v = pair.reversed ? nodes.domain.lo + (nodes.domain.hi - nodes.parameters[i]) : nodes.parameters[i];
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

SectionInStep put_in_step(const Curve& section, const SectionPath& path, double tolerance) {
  const Correspondence& c = path.correspondence;
  Reparametrization law = smooth_law(fit_path(c, path.corners), {tolerance, c.closed, path.pins}, c.reversed);
  Curve curve = c.reversed ? reverse(section) : section;
  if (c.closed) curve = move_seam(curve, law.v.control_points().front()[0]);
  return {compose(curve, law.v), std::move(law)};
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
