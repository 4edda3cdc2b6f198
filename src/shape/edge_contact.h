#pragma once

#include <cstddef>

#include "shape/flattening.h"

namespace tandem {
inline namespace v0 {

/// What two edges that share no vertex do to each other.
struct EdgeContact {
  enum class Kind {
    none,
    crossing,   ///< each has its ends on opposite sides of the other, all further than epsilon from it
    undecided,  ///< they cross nearer to an end, or the first vertex of one lies within epsilon of the other
  };
  Kind kind = Kind::none;
  double share_a = 0.0;  ///< where they meet, as a share of the first edge
  double share_b = 0.0;
};

/// Edges from vertex a to a + 1 and from b to b + 1.
[[nodiscard]] EdgeContact find_contact(const FlatVertex* a, const FlatVertex* b, double epsilon);

/// A point of a flattened path: on the edge from vertex `edge`, at `share` of it.
struct FlatPlace {
  FlatPath path;
  std::size_t edge = 0;
  double share = 0.0;
};

/// Whether two paths that come within epsilon of each other at a and b go through each other there.
///
/// Decided where both enter and leave a circle about a, of 8 epsilons, and where the four points are not
/// apart by more than 2 epsilons there, of 32 and 128.
[[nodiscard]] bool passes_through(const Flattening& flat, const FlatPlace& a, const FlatPlace& b,
                                  double epsilon);

/// Whether the path turns back at its vertex, inside a segment, and runs within 2 epsilons of itself for 10.
[[nodiscard]] bool turns_back(const Flattening& flat, const FlatPath& path, std::size_t vertex,
                              double epsilon);

}  // namespace v0
}  // namespace tandem
