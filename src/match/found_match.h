#pragma once

#include "match/match_samples.h"
#include "match/path_correspondence.h"
#include "match/sample_pair.h"
#include "tandem/curve/curve.h"
#include "tandem/match/correspondence.h"
#include "tandem/match/match.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The best correspondence of two curves, and what the rest of their Match is made from: whoever compares
/// several makes the whole of one.
struct FoundMatch {
  MatchOptions options;  ///< as they were matched: pins settled
  Layout layout = Layout::open;
  SamplePair samples;   ///< both forward
  Samples matched_b;    ///< elastic: the second ones turned back by the rotation, backwards where reversed
  PathParameters path;  ///< nothing when cancelled
  /// All but the fit and what follows it, and elastic's invalid nodes.
  MatchReport report;
};

/// match(a, b, options) as far as the correspondence. @throws InvalidArgument as match()
[[nodiscard]] FoundMatch find_match(const Curve& a, const Curve& b, const MatchOptions& options);

/// The same on samples that are there. They must have been taken of these curves with options that differ in
/// direction, norm, features, elastic and reduction options, rotation or coarse_to_fine only; no pins, not by
/// segments.
[[nodiscard]] FoundMatch find_match(const Curve& a, const Curve& b, const MatchOptions& options,
                                    const MatchSamples& samples);

/// The whole match: with its reparametrisation, its curve, and their validity. a, b: those it was found of
[[nodiscard]] Match finish_match(const Curve& a, const Curve& b, FoundMatch found);

/// Takes another correspondence of the same curves instead.
void follow(FoundMatch& found, Correspondence along);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
