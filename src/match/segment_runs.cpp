#include "match/segment_runs.h"

#include <algorithm>
#include <array>

#include "match/segment_cost.h"
#include "tandem/curve/arc_length.h"
#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

double length_of(const CubicPath& path, std::size_t i) {
  const auto segment = path.segment(i);
  Points points;
  for (const auto& p : segment) points.push_back(p);
  const auto same = [&](const auto& p) { return std::equal(p.begin(), p.end(), segment[0].begin()); };
  if (std::all_of(segment.begin(), segment.end(), same)) return 0.0;
  return arc_length(Curve(3, {0, 0, 0, 0, 1, 1, 1, 1}, std::move(points)));
}

}  // namespace

SegmentVectors segment_vectors(const CubicPath& path, SegmentSplit split, double scale) {
  SegmentVectors result;
  result.dim = static_cast<std::size_t>(path.dim());
  result.closed = path.is_closed();
  for (std::size_t i = 0; i < path.segment_count(); ++i) {
    const auto points = path.segment(i);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t d = 0; d < result.dim; ++d) {
        result.vectors.push_back(points[k + 1][d] / scale - points[k][d] / scale);
      }
    }
    result.shares.push_back(split == SegmentSplit::uniform ? 1.0 : length_of(path, i) / scale);
  }
  return result;
}

SegmentVectors rotated(const SegmentVectors& path, std::size_t first) {
  SegmentVectors result = path;
  std::rotate(result.shares.begin(), result.shares.begin() + static_cast<std::ptrdiff_t>(first),
              result.shares.end());
  std::rotate(result.vectors.begin(),
              result.vectors.begin() + static_cast<std::ptrdiff_t>(3 * path.dim * first),
              result.vectors.end());
  return result;
}

SegmentVectors reversed(const SegmentVectors& path) {
  SegmentVectors result = path;
  const std::size_t n = path.size();
  for (std::size_t i = 0; i < n; ++i) {
    result.shares[i] = path.shares[n - 1 - i];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto from = path.vector(n - 1 - i, 2 - k);
      for (std::size_t d = 0; d < path.dim; ++d) {
        result.vectors[(3 * i + k) * path.dim + d] = -from[d];
      }
    }
  }
  return result;
}

std::vector<double> split_parameters(const SegmentVectors& path, std::size_t first, std::size_t count) {
  std::vector<double> at = {0.0};
  for (std::size_t l = 0; l < count; ++l) at.push_back(at.back() + path.shares[(first + l) % path.size()]);
  const double whole = at.back();
  for (std::size_t l = 1; l < count; ++l) {
    at[l] = whole > 0.0 ? at[l] / whole : static_cast<double>(l) / static_cast<double>(count);
  }
  at.back() = 1.0;
  return at;
}

SegmentRuns::SegmentRuns(const SegmentVectors& path, std::size_t longest)
    : dim_(path.dim),
      longest_(longest),
      energies_(path.size() * longest),
      moments_(path.size() * longest * 3 * path.dim) {
  const std::size_t n = path.size();
  std::vector<double> sums(3 * dim_);
  for (std::size_t first = 0; first < n; ++first) {
    std::fill(sums.begin(), sums.end(), 0.0);
    double time = 0.0;
    double energy = 0.0;
    for (std::size_t count = 1; count <= longest && (path.closed || first + count <= n); ++count) {
      const std::size_t i = (first + count - 1) % n;
      const double h = path.shares[i];
      for (std::size_t d = 0; d < dim_; ++d) {
        const std::array<double, 3> e = {path.vector(i, 0)[d], path.vector(i, 1)[d], path.vector(i, 2)[d]};
        // Integrals of R', t R' and t^2 R' over the segment's own unit of time.
        const double m0 = e[0] + e[1] + e[2];
        const double m1 = 0.25 * e[0] + 0.5 * e[1] + 0.75 * e[2];
        const double m2 = 0.1 * e[0] + 0.3 * e[1] + 0.6 * e[2];
        sums[d] += m0;
        sums[dim_ + d] += time * m0 + h * m1;
        sums[2 * dim_ + d] += time * time * m0 + 2.0 * time * h * m1 + h * h * m2;
      }
      if (h > 0.0) {
        const auto segment = std::span(path.vectors).subspan(3 * dim_ * i, 3 * dim_);
        energy += derivative_energy(segment, dim_) / h;
      }
      time += h;
      const double unit = time > 0.0 ? 1.0 / time : 0.0;
      const std::size_t k = first * longest + count - 1;
      energies_[k] = time * energy;
      for (std::size_t d = 0; d < dim_; ++d) {
        moments_[(3 * k) * dim_ + d] = sums[d];
        moments_[(3 * k + 1) * dim_ + d] = sums[dim_ + d] * unit;
        moments_[(3 * k + 2) * dim_ + d] = sums[2 * dim_ + d] * unit * unit;
      }
    }
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
