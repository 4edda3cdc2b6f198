#pragma once

#include "match/search.h"
#include "tandem/match/match.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The share of the samples that a coarse programme has, which looks where a fine one is worth its time.
inline constexpr int kCoarsening = 4;

struct SamplePair {
  Samples a;
  Samples b;
};

/// How the ends of the curves are tied together. @throws InvalidArgument an open curve where ClosedMode wants
/// closed ones
[[nodiscard]] Layout choose_layout(const Curve& a, const Curve& b, ClosedMode mode);

/// Samples of both curves, as many as the options say, divided by `divisor`. Counts that the caller left open
/// are raised until the elastic steps can bridge them. @throws InvalidArgument as sample(), naming the curve
[[nodiscard]] SamplePair sample_pair(const Curve& a, const Curve& b, const MatchOptions& options,
                                     Layout layout, int divisor);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
