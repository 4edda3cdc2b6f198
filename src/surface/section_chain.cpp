#include "surface/section_chain.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "match/second_curve.h"
#include "surface/even_speed.h"
#include "surface/joint_matching.h"
#include "surface/pair_rails.h"
#include "surface/refine_section.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Of the total cost; less is not worth a sweep.
constexpr double kGain = 1e-4;
/// Laws are fitted ever closer to the path, by this factor, while the fit is what makes sections invalid.
constexpr double kFiner = 4.0;
constexpr int kFinest = 3;
/// For the path itself: a polyline as near to it as it makes sense.
constexpr double kOnPath = 1e-6;
/// Slopes of laws that would be invalid or too far from the path otherwise, as those of rule(): where a part
/// of one section has no counterpart in the other, the other one has to all but stand still meanwhile.
constexpr double kSteep = 1e-3;
/// Share of the length that a law may add to what is invalid of the path itself.
constexpr double kSlack = 2e-4;

Curve identity(Interval u) {
  return Curve::bezier(Points(1, {u.lo, u.hi}), {}, u);
}

NormKind test_of(const SkinOptions& options) {
  const auto* kind = std::get_if<NormKind>(&options.match.norm);
  return kind == nullptr ? NormKind::tangent : *kind;
}

/// What invalid pairs are looked at with once more; the signed test of the plane with either sign.
std::vector<RailNorm> refinements(NormKind test, int dim) {
  if (test != NormKind::ruled) return {tangent_rail_norm()};
  if (dim != 2) return {space_rail_norm()};
  return {planar_rail_norm(1.0), planar_rail_norm(-1.0)};
}

}  // namespace

SectionChain::SectionChain(std::span<const Curve> given, std::vector<SectionPath> paths,
                           const SkinOptions& options)
    : given_(given), paths_(std::move(paths)), options_(&options) {
  const std::vector<SectionPath> matched = paths_;
  const Curve& first = given_.front();
  // Its own parameter is everybody's, unless its speed jumps.
  if (smooth_joints(first, options.match.corner_angle).empty()) {
    set(0, {first, {identity(first.domain()), 0.0, false}});
  } else {
    put(0);
  }
  for (std::size_t k = 1; k < given_.size(); ++k) {
    if (is_stopped()) {
      cancelled_ = true;
      return;
    }
    // It was matched with points of the section before. Within the tolerance they are where its law has them;
    // to follow the law there would only add its own noise.
    if (laws_[k - 1].max_deviation > options.law.tolerance) {
      paths_[k] = carry_over(matched[k], matched[k - 1].correspondence, moved(k - 1, laws_[k - 1]));
    }
    put(k);
  }
  for (std::size_t k = 0; k < pairs(); ++k) costs_.push_back(cost_of(k));
}

bool SectionChain::is_stopped() const {
  return options_->match.progress && !options_->match.progress(1.0);
}

PairCost SectionChain::total() const {
  PairCost sum;
  for (const PairCost& c : costs_) sum = {sum.cost + c.cost, sum.invalid + c.invalid};
  return sum;
}

Validity SectionChain::validity(std::size_t pair) const {
  return check_validity(sections_[pair], sections_[(pair + 1) % sections_.size()], test_of(*options_));
}

bool SectionChain::rematch(std::size_t k) {
  std::vector<Curve> neighbours{sections_[k - 1]};
  if (k + 1 < given_.size() || ring()) neighbours.push_back(sections_[(k + 1) % given_.size()]);
  SectionChain tried = *this;
  std::vector<SectionPath> found = match_between(given_[k], paths_[k], neighbours, options_->match);
  if (found.empty()) return false;
  tried.paths_[k] = std::move(found.front());
  tried.put(k);
  tried.costs_[k - 1] = tried.cost_of(k - 1);
  if (k < pairs()) tried.costs_[k] = tried.cost_of(k);
  if (!is_better(tried.total(), total())) return false;
  *this = std::move(tried);
  return true;
}

int SectionChain::settle() {
  int changed = 0;
  const std::vector<Reparametrization> before = laws_;
  for (std::size_t k = 1; k < given_.size(); ++k) {
    if (is_stopped()) break;
    if (changed > 0) {
      paths_[k] = carry_over(paths_[k], moved(k - 1, before[k - 1]), moved(k - 1, laws_[k - 1]));
      put(k);
    }
    if (settle(k)) ++changed;
  }
  for (std::size_t k = 0; k < pairs(); ++k) costs_[k] = cost_of(k);
  return changed;
}

bool SectionChain::settle(std::size_t k) {
  const double given = defect(k, sections_[k]);
  if (given == 0.0) return false;
  LawOptions law = options_->law;
  law.min_slope = std::min(law.min_slope, kSteep);
  const LawOptions on_path{2, kOnPath, law.min_slope};
  SectionPath best_path = paths_[k];
  double least = try_path(k, best_path, on_path).defect;
  for (SectionPath& path : refined(k)) {
    const double found = try_path(k, path, on_path).defect;
    if (found >= least) continue;
    least = found;
    best_path = std::move(path);
  }
  Tried best{{sections_[k], laws_[k]}, given};
  for (int step = 0; step <= kFinest; ++step, law.tolerance /= kFiner) {
    Tried next = try_path(k, best_path, law);
    if (next.defect < best.defect) best = std::move(next);
    if (best.defect <= least + (least > 0.0 ? kSlack : 0.0)) break;
  }
  if (best.defect >= given) return false;
  set(k, std::move(best.section));
  paths_[k] = std::move(best_path);
  return true;
}

std::vector<SectionPath> SectionChain::refined(std::size_t k) const {
  std::vector<SectionPath> result;
  // A loop that was cut open to be matched has its path in the cut one's parameter.
  if (!(paths_[k].correspondence.domain_v == given_[k].domain())) return result;
  const Curve neighbour = second_curve(given_[k - 1], paths_[k - 1].correspondence, laws_[k - 1]);
  for (const RailNorm& norm : refinements(test_of(*options_), given_[k].dim())) {
    for (const bool along_neighbour : {false, true}) {
      result.push_back(refine_section({neighbour, laws_[k - 1].v}, given_[k], paths_[k], norm,
                                      options_->match.elastic.lambda, along_neighbour));
    }
  }
  return result;
}

double SectionChain::defect(std::size_t k, const Curve& section) const {
  const NormKind test = test_of(*options_);
  double sum = invalidity(check_validity(sections_[k - 1], section, test));
  if (ring() && k + 1 == given_.size()) sum += invalidity(check_validity(section, sections_.front(), test));
  return sum;
}

SectionChain::Tried SectionChain::try_path(std::size_t k, const SectionPath& path,
                                           const LawOptions& law) const {
  SectionInStep section = put_in_step(given_[k], path, law, options_->match.corner_angle);
  const double found = defect(k, section.curve);
  return {std::move(section), found};
}

Correspondence SectionChain::moved(std::size_t k, const Reparametrization& law) const {
  return as_correspondence(law, paths_[k].correspondence, paths_[k].pins);
}

bool SectionChain::is_better(const PairCost& a, const PairCost& b) {
  return a.invalid <= b.invalid && a.cost < b.cost * (1.0 - kGain);
}

void SectionChain::put(std::size_t k) {
  const auto with = [&](const LawOptions& law) {
    return put_in_step(given_[k], paths_[k], law, options_->match.corner_angle);
  };
  SectionInStep section = with(options_->law);
  if (section.law.max_deviation > options_->law.tolerance && options_->law.min_slope > kSteep) {
    SectionInStep steep = with({options_->law.order, options_->law.tolerance, kSteep});
    if (steep.law.max_deviation < section.law.max_deviation) section = std::move(steep);
  }
  set(k, std::move(section));
}

void SectionChain::set(std::size_t k, SectionInStep section) {
  sections_.resize(std::max(sections_.size(), k + 1), section.curve);
  laws_.resize(std::max(laws_.size(), k + 1), section.law);
  looks_.resize(std::max(looks_.size(), k + 1));
  looks_[k] = look_at(section.curve);
  sections_[k] = std::move(section.curve);
  laws_[k] = std::move(section.law);
}

PairCost SectionChain::cost_of(std::size_t pair) const {
  return cost_between(looks_[pair], looks_[(pair + 1) % looks_.size()], options_->match.elastic.lambda);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
