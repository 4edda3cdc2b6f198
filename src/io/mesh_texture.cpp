#include "io/mesh_texture.h"

#include <algorithm>
#include <cstddef>

namespace tandem {
inline namespace v0 {

Points texture_coordinates(const TriangleMesh& mesh) {
  Points result = mesh.parameters;
  for (std::size_t k = 0; k < 2 && !result.empty(); ++k) {
    double lo = result[0][k];
    double hi = lo;
    for (std::size_t i = 0; i < result.size(); ++i) {
      lo = std::min(lo, result[i][k]);
      hi = std::max(hi, result[i][k]);
    }
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i][k] = hi > lo ? (result[i][k] - lo) / (hi - lo) : 0.0;
    }
  }
  return result;
}

}  // namespace v0
}  // namespace tandem
