#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tandem/error.h"
#include "tandem/progress.h"
#include "tandem/rank/compare.h"
#include "tandem/rank/shape_descriptor.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// A shape that is still to be read or sampled. Candidates of one batch are described in parallel.
struct Candidate {
  std::string name;
  std::function<ShapeDescriptor()> describe;
  bool required = false;  ///< what describe() throws ends the run
};

/// Hands out one candidate after the other; nothing: the end. Called from one thread.
using CandidateSource = std::function<std::optional<Candidate>()>;

/// Told about a candidate that could not be described, in the order of the source and on the caller's thread.
/// An empty function: such candidates are passed over.
using CandidateFailure = std::function<void(const Candidate&, const Error&)>;

struct StreamOptions {
  int threads = 0;  ///< 0: all; results do not depend on it
  /// Fraction done, asked after each batch: only the source knows how much there is.
  std::function<double()> fraction = {};
  Progress progress = {};
  CandidateFailure on_failure = {};
};

struct RankOptions {
  CompareOptions compare = {};
  std::size_t top = 0;       ///< how many of the best are kept; 0: all
  bool prune = true;         ///< false: every candidate is compared to the end (the answer is the same)
  bool keep_shapes = false;  ///< the best come with their descriptors, to be drawn, say
  StreamOptions stream = {};
};

struct RankedShape {
  std::string name;  ///< the descriptor's, or the candidate's where that has none
  std::string label;
  std::size_t index = 0;  ///< in the order of the source
  Comparison comparison;
  std::optional<ShapeDescriptor> shape;  ///< with keep_shapes
};

struct Ranking {
  std::vector<RankedShape> best;  ///< by cost, then by index
  std::size_t candidates = 0;     ///< handed out by the source
  std::size_t failed = 0;         ///< could not be described
  std::size_t incomparable = 0;   ///< open against closed, or of another dimension
  std::size_t pruned = 0;         ///< left out by their lower bound, before anything was matched
  bool cancelled = false;         ///< progress said stop: `best` is that of the candidates so far
};

/// The candidates by how well they match the query, best first (spec C15f). Only the best are kept in memory,
/// and one batch of candidates. Lower bounds prune candidates that are certain not to be among the best; the
/// answer is that of comparing all of them, ties included.
[[nodiscard]] TANDEM_EXPORT Ranking rank(const ShapeDescriptor& query, const CandidateSource& source,
                                         const RankOptions& options = {});
[[nodiscard]] TANDEM_EXPORT Ranking rank(const ShapeDescriptor& query,
                                         std::span<const ShapeDescriptor> candidates,
                                         const RankOptions& options = {});

/// Describes every candidate of the source, in parallel, and hands the descriptors on in its order, on the
/// caller's thread. @returns false when progress said stop
TANDEM_EXPORT bool describe_all(const CandidateSource& source,
                                const std::function<void(ShapeDescriptor)>& sink,
                                const StreamOptions& options = {});

}  // namespace v0
}  // namespace tandem
