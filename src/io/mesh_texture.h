#pragma once

#include "tandem/surface/mesh.h"

namespace tandem {
inline namespace v0 {

/// The parameters of a mesh as texture coordinates: each scaled to [0,1] (0 where it does not vary).
[[nodiscard]] Points texture_coordinates(const TriangleMesh& mesh);

}  // namespace v0
}  // namespace tandem
