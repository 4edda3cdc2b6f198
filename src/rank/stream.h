#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <exception>
#include <optional>
#include <vector>

#include "match/parallel_for.h"
#include "tandem/rank/rank.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A batch is little enough to hold in memory, and takes about this long, so that progress is told and a stop
/// is noticed soon; its size has no influence on results.
inline constexpr auto kBatchTime = std::chrono::milliseconds(100);
inline constexpr std::size_t kLeastBatch = 8;
inline constexpr std::size_t kLargestBatch = 1024;

/// The next batch after one of `size` that took `time`.
[[nodiscard]] inline std::size_t next_batch(std::size_t size, std::chrono::steady_clock::duration time) {
  if (time < kBatchTime / 2) return std::min(2 * size, kLargestBatch);
  if (time > 2 * kBatchTime) return std::max(size / 2, kLeastBatch);
  return size;
}

/// A candidate after its describe() has run: a descriptor or what went wrong.
struct Described {
  Candidate candidate;
  std::optional<ShapeDescriptor> shape;
  std::exception_ptr error;
};

/// Throws what a required candidate threw.
inline void report(const Described& each, const StreamOptions& options) {
  try {
    std::rethrow_exception(each.error);
  } catch (const Error& error) {
    if (each.candidate.required) throw;
    if (options.on_failure) options.on_failure(each.candidate, error);
  }
}

/// Runs over the source batch by batch: work(described, index) in parallel for every candidate that could be
/// described, then collect(described, index) for all of them in order, on this thread. Returns false when
/// progress said stop.
template <class Work, class Collect>
bool for_each_described(const CandidateSource& source, const StreamOptions& options, const Work& work,
                        const Collect& collect) {
  std::size_t first = 0;
  std::size_t size = kLeastBatch;
  for (bool more = true; more;) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<Described> batch;
    while (batch.size() < size) {
      std::optional<Candidate> next = source();
      if (!next) {
        more = false;
        break;
      }
      batch.push_back({*std::move(next), std::nullopt, nullptr});
    }
    parallel_for(static_cast<int>(batch.size()), options.threads, [&](int k) {
      Described& each = batch[static_cast<std::size_t>(k)];
      try {
        each.shape = each.candidate.describe();
      } catch (const Error&) {
        each.error = std::current_exception();
        return;
      }
      work(each, first + static_cast<std::size_t>(k));
    });
    for (std::size_t k = 0; k < batch.size(); ++k) {
      if (batch[k].error) report(batch[k], options);
      collect(batch[k], first + k);
    }
    first += batch.size();
    size = next_batch(size, std::chrono::steady_clock::now() - start);
    const double fraction = options.fraction ? options.fraction() : 0.0;
    if (options.progress && !options.progress(more ? fraction : 1.0)) return false;
  }
  return true;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
