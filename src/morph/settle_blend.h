#pragma once

#include "tandem/morph/blend.h"
#include "tandem/morph/morph.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The blend that the options ask for, or that goes with their method.
[[nodiscard]] inline BlendKind settle_blend(const MorphOptions& options) {
  if (options.blend) return *options.blend;
  switch (options.match.method) {
    case Method::paper:
      return BlendKind::affine;
    case Method::segments:
      return BlendKind::hermite;
    default:
      return BlendKind::automatic;
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
