#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "match/segment_runs.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// One segment of one path against `rows` or `cols` of the other: one of the two numbers is 1.
struct SegmentArc {
  std::int32_t rows = 1;
  std::int32_t cols = 1;
  double cost = 0.0;
};

/// The arcs of the graph of joints, by the node that they leave: segments of the first path are rows, of the
/// second one columns. Along closed paths indices are cyclic.
class SegmentArcs {
 public:
  SegmentArcs(const SegmentVectors& rows, const SegmentVectors& cols, SegmentCost cost);

  /// Lists the arcs over runs of up to `longest` segments that cost no more than `most`.
  void list(std::size_t longest, double most);

  [[nodiscard]] int rows() const { return static_cast<int>(rows_.size()); }
  [[nodiscard]] int cols() const { return static_cast<int>(cols_.size()); }
  [[nodiscard]] bool rows_cyclic() const { return rows_.closed; }
  [[nodiscard]] bool cols_cyclic() const { return cols_.closed; }
  /// Drops the arcs of the list for which keep(i, j, arc) is false.
  template <typename Keep>
  void filter(const Keep& keep) {
    std::size_t kept = 0;
    std::size_t next = 0;
    for (std::size_t node = 0; node + 1 < starts_.size(); ++node) {
      for (; next < starts_[node + 1]; ++next) {
        if (!keep(node / cols_.size(), node % cols_.size(), arcs_[next])) continue;
        arcs_[kept++] = arcs_[next];
      }
      starts_[node + 1] = kept;
    }
    arcs_.resize(kept);
  }
  /// From the joint before row i and column j; both are taken modulo the sizes where those are cyclic.
  [[nodiscard]] std::span<const SegmentArc> from(std::size_t i, std::size_t j) const {
    const std::size_t k = i * cols_.size() + j;
    return {arcs_.data() + starts_[k], starts_[k + 1] - starts_[k]};
  }

 private:
  /// A path as single segments that meet runs of the other.
  struct Singles {
    std::vector<double> energies;  ///< integral of |Q'|^2, or a bound of the paper's sum of squares
    std::vector<double> powers;    ///< Q' = c0 + c1 t + c2 t^2: 3 * dim per segment
  };

  [[nodiscard]] static Singles singles(const SegmentVectors& path, SegmentCost cost);
  void add_runs(const SegmentVectors& one, const Singles& single, std::size_t i, const SegmentVectors& run,
                const SegmentRuns& runs, std::size_t first, bool one_is_row, std::size_t longest,
                double most);
  [[nodiscard]] double cost_of(const SegmentVectors& one, const Singles& single, std::size_t i,
                               const SegmentVectors& run, const SegmentRuns& runs, std::size_t first,
                               std::size_t count, double most) const;

  const SegmentVectors& rows_;
  const SegmentVectors& cols_;
  SegmentCost cost_;
  Singles row_singles_;
  Singles col_singles_;
  std::vector<std::size_t> starts_;
  std::vector<SegmentArc> arcs_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
