#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/match/segments.h"
#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The segments of a path as the costs see them: three control differences each, and the share of time that
/// each wants.
struct SegmentVectors {
  std::size_t dim = 0;
  bool closed = false;
  std::vector<double> vectors;  ///< 3 * dim per segment
  std::vector<double> shares;   ///< per segment: its arc length, or 1

  [[nodiscard]] std::size_t size() const { return shares.size(); }
  /// Control difference k of segment i (modulo the number of segments).
  [[nodiscard]] std::span<const double> vector(std::size_t i, std::size_t k) const {
    return {vectors.data() + (i % size() * 3 + k) * dim, dim};
  }
};

/// All coordinates divided by `scale`, a power of two.
[[nodiscard]] SegmentVectors segment_vectors(const CubicPath& path, SegmentSplit split, double scale);
/// The same path from joint `first` on, and backwards.
[[nodiscard]] SegmentVectors rotated(const SegmentVectors& path, std::size_t first);
[[nodiscard]] SegmentVectors reversed(const SegmentVectors& path);

/// Where one segment is split that meets segments first, .. first + count - 1: count + 1 parameters from 0 to
/// 1. Equal shares where none of the segments has a length.
[[nodiscard]] std::vector<double> split_parameters(const SegmentVectors& path, std::size_t first,
                                                   std::size_t count);

/// Runs of consecutive segments, each run through in a unit of time: what the derivative's cost needs to know
/// of them, so that it takes the same time for every run.
class SegmentRuns {
 public:
  /// longest: of the runs that are wanted.
  SegmentRuns(const SegmentVectors& path, std::size_t longest);

  struct Run {
    double energy = 0.0;  ///< integral of |R'|^2
    /// dim each: integrals of R', t R' and t^2 R'
    const double* moments = nullptr;
  };
  /// count >= 1 segments from `first` on.
  [[nodiscard]] Run run(std::size_t first, std::size_t count) const {
    const std::size_t k = first * longest_ + count - 1;
    return {energies_[k], moments_.data() + k * 3 * dim_};
  }

 private:
  std::size_t dim_;
  std::size_t longest_;
  std::vector<double> energies_;
  std::vector<double> moments_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
