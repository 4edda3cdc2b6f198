#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "surface/section_laws.h"
#include "surface/skin_report.h"
#include "tandem/curve/curve.h"
#include "tandem/match/reparametrization.h"
#include "tandem/match/validity.h"
#include "tandem/surface/skin.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// All sections in step with their paths, and what each pair of neighbours costs.
class SectionChain {
 public:
  SectionChain(std::span<const Curve> given, std::vector<SectionPath> paths, const SkinOptions& options);

  /// Before all sections were in step: there is nothing to be had of this then.
  [[nodiscard]] bool cancelled() const { return cancelled_; }
  [[nodiscard]] const std::vector<Curve>& sections() const { return sections_; }
  [[nodiscard]] const std::vector<Reparametrization>& laws() const { return laws_; }
  [[nodiscard]] const std::vector<SectionPath>& paths() const { return paths_; }
  [[nodiscard]] const std::vector<PairCost>& costs() const { return costs_; }
  [[nodiscard]] bool ring() const { return options_->loft.closed; }
  [[nodiscard]] std::size_t pairs() const { return ring() ? given_.size() : given_.size() - 1; }
  [[nodiscard]] PairCost total() const;
  /// Of a section and the next, as they are in step.
  [[nodiscard]] Validity validity(std::size_t pair) const;

  /// Matches a section, not the first, with both of its neighbours again; kept if that is better.
  bool rematch(std::size_t k);

  /// Where a section is invalid against the one before it, looks once more beside its path, and takes the
  /// first law, of ever smaller tolerances, that is no worse than the path itself; else the least bad one.
  /// Later sections follow. Returns how many paths were changed.
  int settle();

  /// No more invalid, and cheaper by more than rounding.
  [[nodiscard]] static bool is_better(const PairCost& a, const PairCost& b);

 private:
  /// A section in step that was tried, and the share of the length on which it is invalid.
  struct Tried {
    SectionInStep section;
    double defect = 0.0;
  };

  [[nodiscard]] bool is_stopped() const;
  void set(std::size_t k, SectionInStep section);
  void put(std::size_t k);
  [[nodiscard]] PairCost cost_of(std::size_t pair) const;
  [[nodiscard]] double defect(std::size_t k, const Curve& section) const;
  [[nodiscard]] Tried try_path(std::size_t k, const SectionPath& path, const LawOptions& law) const;
  [[nodiscard]] std::vector<SectionPath> refined(std::size_t k) const;
  bool settle(std::size_t k);
  /// Where a law has section k, as points of a path.
  [[nodiscard]] Correspondence moved(std::size_t k, const Reparametrization& law) const;

  std::span<const Curve> given_;
  std::vector<SectionPath> paths_;
  const SkinOptions* options_;
  std::vector<Curve> sections_;
  std::vector<Reparametrization> laws_;
  std::vector<SectionLook> looks_;
  std::vector<PairCost> costs_;
  bool cancelled_ = false;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
