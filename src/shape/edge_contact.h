#pragma once

#include <cstddef>
#include <optional>

#include "shape/flattening.h"

namespace tandem {
inline namespace v0 {

/// What two edges that share no vertex do to each other.
struct EdgeContact {
  enum class Kind {
    none,
    crossing,   ///< each has its ends on opposite sides of the other, all further than epsilon from it
    undecided,  ///< an end lies within epsilon of the other
  };
  Kind kind = Kind::none;
  double share_a = 0.0;  ///< of a crossing: where on the first edge, in (0, 1)
  double share_b = 0.0;
};

/// Edges from vertex a to a + 1 and from b to b + 1.
[[nodiscard]] EdgeContact find_contact(const FlatVertex* a, const FlatVertex* b, double epsilon);

/// Whether the path goes through the other one at its vertex `vertex`, which lies within epsilon of the
/// other's edge [edge, edge + 1]: where on that edge, as a share of it; nothing when it does not.
///
/// Decided where both enter and leave a circle about the vertex, of 8 epsilons, and where the four points are
/// not apart by more than 2 epsilons there, of 32 and 128.
[[nodiscard]] std::optional<double> passes_through(const Flattening& flat, const FlatPath& path,
                                                   std::size_t vertex, const FlatPath& other,
                                                   std::size_t edge, double epsilon);

/// Whether the path turns back at its vertex, inside a segment, and runs within 2 epsilons of itself for 10.
[[nodiscard]] bool turns_back(const Flattening& flat, const FlatPath& path, std::size_t vertex,
                              double epsilon);

}  // namespace v0
}  // namespace tandem
