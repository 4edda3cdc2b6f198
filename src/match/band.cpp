#include "match/band.h"

#include <algorithm>
#include <cmath>

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// The unrolled sample of `fine` at, or next below, unrolled sample k of `coarse`.
int same_place(const Samples& fine, const Samples& coarse, int k) {
  const int coarse_size = static_cast<int>(coarse.size());
  const int size = static_cast<int>(fine.size());
  int lap = k / coarse_size - (k % coarse_size < 0 ? 1 : 0);
  double t = coarse.parameters[static_cast<std::size_t>(k - lap * coarse_size)];
  if (fine.cyclic) {
    const int wraps = static_cast<int>(std::floor((t - fine.parameters.front()) / fine.period));
    t -= wraps * fine.period;
    lap += wraps;
  }
  const auto above = std::upper_bound(fine.parameters.begin(), fine.parameters.end(), t);
  return lap * size + std::max(0, static_cast<int>(above - fine.parameters.begin()) - 1);
}

/// The path on the fine samples, as a line through places of the coarse one's nodes.
class Line {
 public:
  Line(const Grid& fine, const Grid& coarse, const std::vector<Node>& path)
      : cyclic_(fine.rows.cyclic && fine.cols.cyclic),
        rows_(static_cast<int>(fine.rows.size())),
        cols_(static_cast<int>(fine.cols.size())) {
    for (const Node& node : path) {
      nodes_.push_back(
          {same_place(fine.rows, coarse.rows, node.i), same_place(fine.cols, coarse.cols, node.j)});
    }
    // The path begins and ends where the curve does, or a lap on, whatever lies next below.
    if (!fine.rows.cyclic) nodes_.back().i = rows_ - 1;
    if (!fine.cols.cyclic) nodes_.back().j = cols_ - 1;
  }

  [[nodiscard]] int first_row() const { return nodes_.front().i; }
  [[nodiscard]] int first_col() const { return nodes_.front().j; }

  /// Column of the line at row i; before the path and after it, where it goes on a lap away, or its ends.
  [[nodiscard]] double at(int i) const {
    int lap = 0;
    if (cyclic_) {
      lap = static_cast<int>(std::floor(static_cast<double>(i - first_row()) / rows_));
      i -= lap * rows_;
    }
    const auto above =
        std::upper_bound(nodes_.begin(), nodes_.end(), i, [](int row, const Node& n) { return row < n.i; });
    double column = nodes_.front().j;
    if (above == nodes_.end()) {
      column = nodes_.back().j;
    } else if (above != nodes_.begin()) {
      const Node& from = *(above - 1);
      column = from.j + static_cast<double>(above->j - from.j) * (i - from.i) / (above->i - from.i);
    }
    return column + static_cast<double>(lap) * cols_;
  }

 private:
  bool cyclic_;
  int rows_;
  int cols_;
  std::vector<Node> nodes_;
};

}  // namespace

Band band_near(const Grid& fine, const Grid& coarse, const std::vector<Node>& path, int radius,
               int first_cols) {
  const Line line(fine, coarse, path);
  const int rows = static_cast<int>(fine.rows.size());
  const auto range = [&](int i) {
    return Band::Range{static_cast<int>(std::floor(std::min(line.at(i) - radius, line.at(i - radius)))),
                       static_cast<int>(std::ceil(std::max(line.at(i) + radius, line.at(i + radius)))) + 1};
  };
  Band band;
  int last_row = rows - 1;
  if (fine.rows.cyclic) {
    // Paths start where the band crosses column 0: all rows whose ranges meet the first columns.
    int row = line.first_row();
    if (fine.cols.cyclic) {
      while (range(row).hi >= 0) row -= rows;
      while (range(row).hi < 0) ++row;
      band.first_row = row;
      while (range(row).lo < first_cols && row < band.first_row + rows) ++row;
    } else {
      band.first_row = row - radius;
      row += std::min(radius, rows - radius - 1) + 1;
    }
    last_row = row - 1 + rows;
  }
  for (int i = band.first_row; i <= last_row; ++i) band.columns.push_back(range(i));
  return band;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
