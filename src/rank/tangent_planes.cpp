#include "rank/tangent_planes.h"

#include <cstddef>
#include <vector>

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Row-major.
std::vector<double> matrix_of(const Rotation& rotation) {
  const std::vector<double>& values = rotation.values();
  if (rotation.dim() != 2) return values;
  return {values[0], -values[1], values[1], values[0]};
}

}  // namespace

TangentPlanes to_planes(const Points& tangents) {
  const auto dim = static_cast<std::size_t>(tangents.dim());
  TangentPlanes result;
  for (std::size_t c = 0; c < dim; ++c) {
    std::vector<double>& plane = result.planes.emplace_back(tangents.size());
    for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = tangents[i][c];
  }
  return result;
}

TangentPlanes turned(const TangentPlanes& tangents, const Rotation& rotation) {
  const std::vector<double> matrix = matrix_of(rotation);
  const std::size_t dim = tangents.planes.size();
  TangentPlanes result;
  for (std::size_t r = 0; r < dim; ++r) {
    std::vector<double>& plane = result.planes.emplace_back(tangents.size(), 0.0);
    for (std::size_t c = 0; c < dim; ++c) {
      const double factor = matrix[r * dim + c];
      for (std::size_t i = 0; i < plane.size(); ++i) plane[i] += factor * tangents.planes[c][i];
    }
  }
  return result;
}

Rotation product(const Rotation& second, const Rotation& first) {
  const std::vector<double> x = matrix_of(second);
  const std::vector<double> y = matrix_of(first);
  const auto n = static_cast<std::size_t>(first.dim());
  std::vector<double> values(n * n, 0.0);
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t c = 0; c < n; ++c) {
      for (std::size_t k = 0; k < n; ++k) values[r * n + c] += x[r * n + k] * y[k * n + c];
    }
  }
  if (n == 2) values = {values[0], values[2]};
  return {first.dim(), values};
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
