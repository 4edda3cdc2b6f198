#include "tandem/surface/skin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "surface/check_loft.h"
#include "surface/joint_matching.h"
#include "surface/section_laws.h"
#include "surface/skin_report.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/nearest_point.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::PairCost;
using detail::SectionInStep;
using detail::SectionPath;

// Sections nearer than this share of their size, at kPlaces places, are one.
constexpr double kCoincident = 1e-9;
constexpr int kPlaces = 24;
// Where a ring is slow to settle, later sweeps gain little.
constexpr int kMostSweeps = 8;

/// Does every point of a, of some dozens, lie on b?
bool lies_on(const Curve& a, const Curve& b) {
  for (int i = 0; i <= kPlaces; ++i) {
    const Point p = a.evaluate(a.domain().lo + a.domain().length() * i / kPlaces);
    if (nearest_point(b, p).distance > kCoincident * b.extent()) return false;
  }
  return true;
}

/// Matched, one curve drawn twice would be no further apart than its laws are off: it is looked for before.
void check_distinct(std::span<const Curve> sections, bool ring) {
  for (std::size_t k = 0; k + (ring ? 0 : 1) < sections.size(); ++k) {
    const std::size_t next = (k + 1) % sections.size();
    const Curve& a = sections[k];
    const Curve& b = sections[next];
    if (next == k || a.dim() != b.dim() || !lies_on(a, b) || !lies_on(b, a)) continue;
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
  if (!(options.law_tolerance > 0.0)) {
    throw InvalidArgument(fmt::format("the laws' tolerance is {}, expected > 0", options.law_tolerance));
  }
}

Curve identity(Interval u) {
  return Curve::bezier(Points(1, {u.lo, u.hi}), {}, u);
}

/// All sections in step with their paths, and what each pair of neighbours costs.
class Chain {
 public:
  Chain(std::span<const Curve> given, std::vector<SectionPath> paths, const SkinOptions& options)
      : given_(given), paths_(std::move(paths)), options_(&options) {
    const Curve& first = given_.front();
    set(0, {first, {identity(first.domain()), 0.0, false}});
    for (std::size_t k = 1; k < given_.size(); ++k) {
      set(k, detail::put_in_step(given_[k], paths_[k], options.law_tolerance));
    }
    for (std::size_t k = 0; k < pairs(); ++k) costs_.push_back(cost_of(k));
  }

  [[nodiscard]] const std::vector<Curve>& sections() const { return sections_; }
  [[nodiscard]] const std::vector<Reparametrization>& laws() const { return laws_; }
  [[nodiscard]] const std::vector<SectionPath>& paths() const { return paths_; }
  [[nodiscard]] const std::vector<PairCost>& costs() const { return costs_; }
  [[nodiscard]] bool ring() const { return options_->loft.closed; }
  [[nodiscard]] std::size_t pairs() const { return ring() ? given_.size() : given_.size() - 1; }
  [[nodiscard]] PairCost total() const {
    PairCost sum;
    for (const PairCost& c : costs_) sum = {sum.cost + c.cost, sum.invalid + c.invalid};
    return sum;
  }

  /// Matches a section, not the first, with both of its neighbours again; kept if that is better.
  bool rematch(std::size_t k) {
    std::vector<Curve> neighbours{sections_[k - 1]};
    if (k + 1 < given_.size() || ring()) neighbours.push_back(sections_[(k + 1) % given_.size()]);
    Chain tried = *this;
    std::vector<SectionPath> found =
        detail::match_between(given_[k], paths_[k], neighbours, options_->match);
    if (found.empty()) return false;
    tried.paths_[k] = std::move(found.front());
    tried.set(k, detail::put_in_step(given_[k], tried.paths_[k], options_->law_tolerance));
    tried.costs_[k - 1] = tried.cost_of(k - 1);
    if (k < pairs()) tried.costs_[k] = tried.cost_of(k);
    if (!is_better(tried.total(), total())) return false;
    *this = std::move(tried);
    return true;
  }

  /// No more invalid, and cheaper by more than rounding.
  [[nodiscard]] static bool is_better(const PairCost& a, const PairCost& b) {
    return a.invalid <= b.invalid && a.cost < b.cost * (1.0 - kGain);
  }

 private:
  // Of the total cost; less is not worth a sweep.
  static constexpr double kGain = 1e-4;

  void set(std::size_t k, SectionInStep section) {
    sections_.resize(std::max(sections_.size(), k + 1), section.curve);
    laws_.resize(std::max(laws_.size(), k + 1), section.law);
    looks_.resize(std::max(looks_.size(), k + 1));
    looks_[k] = detail::look_at(section.curve);
    sections_[k] = std::move(section.curve);
    laws_[k] = std::move(section.law);
  }
  [[nodiscard]] PairCost cost_of(std::size_t pair) const {
    return detail::cost_between(looks_[pair], looks_[(pair + 1) % looks_.size()],
                                options_->match.elastic.lambda);
  }

  std::span<const Curve> given_;
  std::vector<SectionPath> paths_;
  const SkinOptions* options_;
  std::vector<Curve> sections_;
  std::vector<Reparametrization> laws_;
  std::vector<detail::SectionLook> looks_;
  std::vector<PairCost> costs_;
};

/// Of a ring: what is left over once round it shared by all sections, if that is better.
void spread_left_over(Chain& chain, std::span<const Curve> given, const SkinOptions& options) {
  MatchOptions last = options.match;
  const SectionPath& before = chain.paths().back();
  last.direction = before.correspondence.reversed ? Direction::reversed : Direction::forward;
  const SectionPath round = detail::follow(before, match(given.back(), given.front(), last));
  Chain spread(given, detail::spread_round(chain.paths(), round), options);
  if (Chain::is_better(spread.total(), chain.total())) chain = std::move(spread);
}

/// Sweeps along the chain until the total cost stops falling. Returns how many lowered it.
int sweep(Chain& chain) {
  for (int sweeps = 0; sweeps < kMostSweeps; ++sweeps) {
    bool better = false;
    for (std::size_t k = 1; k < chain.sections().size(); ++k) better = chain.rematch(k) || better;
    if (!better) return sweeps;
  }
  return kMostSweeps;
}

SkinReport report_on(const Chain& chain, const Loft& made, const SkinOptions& options) {
  SkinReport report;
  const std::vector<Curve>& sections = chain.sections();
  const auto* kind = std::get_if<NormKind>(&options.match.norm);
  report.valid = true;
  for (std::size_t k = 0; k < chain.pairs(); ++k) {
    const std::size_t next = (k + 1) % sections.size();
    SkinPair pair;
    pair.validity = check_validity(sections[k], sections[next], kind == nullptr ? NormKind::tangent : *kind);
    pair.cost = chain.costs()[k].cost;
    pair.direction = chain.laws()[k].reversed == chain.laws()[next].reversed ? Direction::forward
                                                                             : Direction::reversed;
    report.valid = report.valid && pair.validity.valid;
    report.pairs.push_back(pair);
  }
  report.total_cost = chain.total().cost;
  for (const Reparametrization& law : chain.laws()) {
    report.law_deviation = std::max(report.law_deviation, law.max_deviation);
  }
  report.crease_angle =
      detail::crease_angle(made.surface, sections, made.parameters, options.match.corner_angle);
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
  Chain chain(sections, std::move(paths), options);
  const double sequence_cost = chain.total().cost;
  int sweeps = 0;
  const SkinMatching by_default = chain.ring() ? SkinMatching::joint : SkinMatching::sequence;
  if (options.matching.value_or(by_default) == SkinMatching::joint && options.pins.empty()) {
    if (chain.ring()) spread_left_over(chain, sections, options);
    sweeps = sweep(chain);
  }
  Loft made = loft(chain.sections(), options.loft);
  SkinReport report = report_on(chain, made, options);
  report.sequence_cost = sequence_cost;
  report.sweeps = sweeps;
  return {std::move(made.surface), std::move(made.parameters), chain.sections(), chain.laws(),
          std::move(report)};
}

}  // namespace v0
}  // namespace tandem
