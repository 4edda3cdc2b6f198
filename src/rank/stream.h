#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "match/parallel_for.h"
#include "tandem/rank/rank.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Enough work for all threads, and little enough to hold in memory and to notice Ctrl-C soon.
inline constexpr std::size_t kBatch = 256;

/// A candidate after its describe() has run: a descriptor or what went wrong.
struct Described {
  Candidate candidate;
  std::optional<ShapeDescriptor> shape;
  std::optional<Error> error;
};

/// Runs over the source batch by batch: work(described, index) in parallel for every candidate that could be
/// described, then collect(described, index) for all of them in order, on this thread. Returns false when
/// progress said stop.
template <class Work, class Collect>
bool for_each_described(const CandidateSource& source, const StreamOptions& options, const Work& work,
                        const Collect& collect) {
  std::size_t first = 0;
  for (bool more = true; more;) {
    std::vector<Described> batch;
    while (batch.size() < kBatch) {
      std::optional<Candidate> next = source();
      if (!next) {
        more = false;
        break;
      }
      batch.push_back({*std::move(next), std::nullopt, std::nullopt});
    }
    parallel_for(static_cast<int>(batch.size()), options.threads, [&](int k) {
      Described& each = batch[static_cast<std::size_t>(k)];
      try {
        each.shape = each.candidate.describe();
      } catch (const Error& error) {
        each.error = error;
        return;
      }
      work(each, first + static_cast<std::size_t>(k));
    });
    for (std::size_t k = 0; k < batch.size(); ++k) {
      if (batch[k].error && options.on_failure) options.on_failure(batch[k].candidate, *batch[k].error);
      collect(batch[k], first + k);
    }
    first += batch.size();
    const double fraction = options.fraction ? options.fraction() : 0.0;
    if (options.progress && !options.progress(more ? fraction : 1.0)) return false;
  }
  return true;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
