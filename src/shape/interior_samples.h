#pragma once

#include <cstddef>
#include <vector>

#include "shape/flattening.h"

namespace tandem {
inline namespace v0 {

/// A point inside a path, and how much of the inside it stands for.
struct InteriorSample {
  Vec2 point;
  double weight = 0.0;
};

/// Points inside a flattened path (winding number not 0; an open one is closed by a line), on scanlines
/// across it; none when it encloses nothing. The weights add up to about the area.
[[nodiscard]] std::vector<InteriorSample> sample_interior(const Flattening& flat, const FlatPath& path);

/// How often the path winds around p counter-clockwise; for p on the path one of the values beside it.
[[nodiscard]] int winding_number(const Flattening& flat, const FlatPath& path, Vec2 p);

}  // namespace v0
}  // namespace tandem
