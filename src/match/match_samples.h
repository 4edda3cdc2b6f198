#pragma once

#include <memory>

#include "match/edge_plan.h"
#include "match/sample_pair.h"
#include "tandem/curve/curve.h"
#include "tandem/match/match.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// What matching looks at of two curves: whoever matches them several times takes it once.
struct MatchSamples {
  SamplePair fine;
  SamplePair coarse;  ///< of the same curves, fewer
  Layout layout = Layout::open;
  std::shared_ptr<EdgePlans> plans = std::make_shared<EdgePlans>();  ///< of these samples
};

/// The samples that match() would take. @throws InvalidArgument as match()
[[nodiscard]] MatchSamples sample_for_match(const Curve& a, const Curve& b, const MatchOptions& options);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
