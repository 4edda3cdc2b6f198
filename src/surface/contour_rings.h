#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/triangulate_region.h"
#include "surface/vector3.h"
#include "tandem/curve/curve.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Vertices of a stack of contours: places in the planes' common coordinates, and heights.
struct StackVertices {
  std::vector<Vec2> places;
  std::vector<double> heights;

  std::uint32_t add(Vec2 place, double height) {
    places.push_back(place);
    heights.push_back(height);
    return static_cast<std::uint32_t>(places.size() - 1);
  }
};

/// A contour as a polyline: solids counter-clockwise seen from above, holes clockwise.
struct Ring {
  Loop loop;
  bool hole = false;
  std::size_t depth = 0;   ///< number of the level's contours that it lies in
  std::size_t parent = 0;  ///< the innermost of them, where depth > 0
};

/// A stack of levels; the planes' coordinates in units of `scale` from `origin`, along the axes.
struct ContourStack {
  Vector3 origin{};
  Vector3 axis_x{};
  Vector3 axis_y{};
  Vector3 normal{};
  double scale = 1.0;
  StackVertices vertices;
  std::vector<std::vector<Ring>> levels;

  [[nodiscard]] Vector3 position(std::uint32_t vertex) const {
    const Vec2 p = vertices.places[vertex];
    return origin + scale * (p.x * axis_x + p.y * axis_y + vertices.heights[vertex] * normal);
  }
};

/// @throws InvalidArgument as contours_to_solid(), for what is wrong with levels
[[nodiscard]] ContourStack make_stack(std::span<const std::vector<Curve>> levels, double chord,
                                      double longest_edge);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
