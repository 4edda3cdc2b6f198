#include "match/candidates.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Reversed must beat forward by more than rounding, relative to the cost.
constexpr double kTie = 1e-12;

}  // namespace

std::vector<Candidate> list_candidates(int dim, const MatchOptions& options) {
  std::vector<RuledSign> signs = {RuledSign::product};
  const auto* kind = std::get_if<NormKind>(&options.norm);
  if (kind != nullptr && *kind == NormKind::ruled && dim == 2 && options.method != Method::paper) {
    signs = {RuledSign::positive, RuledSign::negative};
  }
  std::vector<Candidate> candidates;
  for (const bool reversed : {false, true}) {
    if (options.direction == (reversed ? Direction::forward : Direction::reversed)) continue;
    for (const RuledSign sign : signs) candidates.push_back({reversed, sign});
  }
  return candidates;
}

Aggregate aggregate_of(const Norm& norm) {
  const auto* kind = std::get_if<NormKind>(&norm);
  return kind != nullptr && *kind == NormKind::bottleneck ? Aggregate::maximum : Aggregate::sum;
}

bool clearly_better(const Path& x, const Path& y) {
  if (y.nodes.empty()) return !x.nodes.empty();
  if (x.nodes.empty() || x.invalid != y.invalid) return !x.nodes.empty() && x.invalid < y.invalid;
  return x.cost < y.cost - kTie * y.cost;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
