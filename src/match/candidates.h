#pragma once

#include <vector>

#include "tandem/match/match.h"
#include "tandem/match/norm.h"
#include "tandem/match/programme.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// One of the programmes that a search runs.
struct Candidate {
  bool reversed = false;
  RuledSign sign = RuledSign::product;
};

/// Forward ones first. dim: of the curves.
[[nodiscard]] std::vector<Candidate> list_candidates(int dim, const MatchOptions& options);

[[nodiscard]] Aggregate aggregate_of(const Norm& norm);

/// By more than rounding.
[[nodiscard]] bool clearly_better(const Path& x, const Path& y);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
