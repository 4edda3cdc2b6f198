#include "tandem/surface/skin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "surface/check_loft.h"
#include "surface/check_rails.h"
#include "surface/joint_matching.h"
#include "surface/section_chain.h"
#include "surface/skin_report.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::SectionChain;
using detail::SectionPath;

// Where a ring is slow to settle, later sweeps gain little.
constexpr int kMostSweeps = 8;

void check_distinct(std::span<const Curve> sections, bool ring) {
  for (std::size_t k = 0; k + (ring ? 0 : 1) < sections.size(); ++k) {
    const std::size_t next = (k + 1) % sections.size();
    if (next == k || !detail::do_coincide(sections[k], sections[next])) continue;
    throw InvalidArgument(fmt::format("sections {} and {} coincide, expected distinct neighbours", k, next));
  }
}

void check(std::span<const Curve> sections, const SkinOptions& options) {
  for (std::size_t k = 0; k < options.pins.size(); ++k) {
    if (options.pins[k].size() == sections.size()) continue;
    throw InvalidArgument(fmt::format("pin {} has {} parameters for {} sections, expected one each", k,
                                      options.pins[k].size(), sections.size()));
  }
  if (sections.size() > 1) check_distinct(sections, options.loft.closed);
}

/// Of a ring: what is left over once round it shared by all sections, if that is better.
void spread_left_over(SectionChain& chain, std::span<const Curve> given, const SkinOptions& options) {
  MatchOptions last = options.match;
  const SectionPath& before = chain.paths().back();
  last.direction = before.correspondence.reversed ? Direction::reversed : Direction::forward;
  const SectionPath round = detail::follow(before, match(given.back(), given.front(), last));
  SectionChain spread(given, detail::spread_round(chain.paths(), round), options);
  if (spread.cancelled()) return;
  static_cast<void>(spread.settle());
  if (SectionChain::is_better(spread.total(), chain.total())) chain = std::move(spread);
}

bool is_cancelled(const SkinOptions& options) {
  return options.match.progress && !options.match.progress(1.0);
}

/// Sweeps along the chain until the total cost stops falling. Returns how many lowered it.
int sweep(SectionChain& chain, const SkinOptions& options) {
  for (int sweeps = 0; sweeps < kMostSweeps; ++sweeps) {
    bool better = false;
    for (std::size_t k = 1; k < chain.sections().size() && !is_cancelled(options); ++k)
      better = chain.rematch(k) || better;
    if (!better) return sweeps;
  }
  return kMostSweeps;
}

SkinReport report_on(const SectionChain& chain, const Loft& made, const SkinOptions& options) {
  SkinReport report;
  const std::vector<Curve>& sections = chain.sections();
  report.valid = true;
  for (std::size_t k = 0; k < chain.pairs(); ++k) {
    const std::size_t next = (k + 1) % sections.size();
    SkinPair pair;
    pair.validity = chain.validity(k);
    pair.cost = chain.costs()[k].cost;
    pair.direction =
        chain.laws()[k].reversed == chain.laws()[next].reversed ? Direction::forward : Direction::reversed;
    report.valid = report.valid && pair.validity.valid;
    report.pairs.push_back(pair);
  }
  report.total_cost = chain.total().cost;
  // The first one's only says at which parameters all others meet it.
  for (std::size_t k = 1; k < sections.size(); ++k)
    report.law_deviation = std::max(report.law_deviation, chain.laws()[k].max_deviation);
  const detail::Creases creases =
      detail::find_creases(made.surface, sections, made.parameters, options.match.corner_angle);
  report.crease_angle = creases.laws;
  report.section_crease_angle = creases.sections;
  report.wrong_sign_share = detail::wrong_sign_share(made.surface);
  report.interpolation_error = detail::interpolation_error(made.surface, sections, made.parameters);
  return report;
}

SkinnedSurface cancelled_skin(std::span<const Curve> given, const SkinOptions& options) {
  std::vector<Curve> sections;
  for (const Curve& section : given) sections.push_back(with_domain(section, given.front().domain()));
  Loft made = loft(sections, options.loft);
  SkinReport report;
  report.cancelled = true;
  std::vector<Reparametrization> laws;
  for (const Curve& section : given) {
    const Interval u = given.front().domain();
    const Interval v = section.domain();
    laws.push_back({Curve::bezier(Points(1, {v.lo, v.hi}), {}, u), 0.0, false});
  }
  return {std::move(made.surface), std::move(made.parameters), std::move(sections), std::move(laws),
          std::move(report)};
}

}  // namespace

SkinnedSurface skin(std::span<const Curve> sections, const SkinOptions& options) {
  check(sections, options);
  detail::check_loft(sections, options.loft);
  std::vector<SectionPath> paths = detail::match_in_sequence(sections, options);
  if (paths.empty()) return cancelled_skin(sections, options);
  SectionChain chain(sections, std::move(paths), options);
  if (chain.cancelled()) return cancelled_skin(sections, options);
  int refined = chain.settle();
  const double sequence_cost = chain.total().cost;
  int sweeps = 0;
  const SkinMatching by_default = chain.ring() ? SkinMatching::joint : SkinMatching::sequence;
  if (options.matching.value_or(by_default) == SkinMatching::joint && options.pins.empty()) {
    if (chain.ring()) spread_left_over(chain, sections, options);
    sweeps = sweep(chain, options);
    if (chain.ring() || sweeps > 0) refined += chain.settle();
  }
  if (is_cancelled(options)) return cancelled_skin(sections, options);
  Loft made = loft(chain.sections(), options.loft);
  if (is_cancelled(options)) return cancelled_skin(sections, options);
  SkinReport report = report_on(chain, made, options);
  report.sequence_cost = sequence_cost;
  report.sweeps = sweeps;
  report.refined = refined;
  return {std::move(made.surface), std::move(made.parameters), chain.sections(), chain.laws(),
          std::move(report)};
}

}  // namespace v0
}  // namespace tandem
