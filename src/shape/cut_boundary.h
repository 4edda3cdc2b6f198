#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shape/flattening.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {

/// Area and centroid of a region, in the units of a CutBoundary.
struct Region {
  double area = 0.0;  ///< counter-clockwise positive
  Vec2 centroid;
};

/// A closed contour as a polygon with the places between which it may be cut, in units of `scale` about the
/// centre of its box (Flattening); counter-clockwise or clockwise.
class CutBoundary {
 public:
  /// scale: absolute, > 0
  CutBoundary(const CubicPath& contour, std::span<const CubicPath> holes, double scale);

  /// Number of places; neighbours are some 130th of the outline apart, joints are preferred.
  [[nodiscard]] std::size_t size() const noexcept { return places_.size(); }
  [[nodiscard]] double parameter(std::size_t place) const { return vertices_[places_[place]].u; }
  [[nodiscard]] Vec2 point(std::size_t place) const { return position(places_[place]); }
  [[nodiscard]] Vec2 to_flat(Vec2 p) const { return flat_.to_flat(p.x, p.y); }

  [[nodiscard]] Region whole() const;
  /// What the outline from place a on to place b > a encloses with the chord back.
  [[nodiscard]] Region side(std::size_t a, std::size_t b) const;
  /// Whether the chord lies inside, clear of everything. last_block: what blocked a chord before, looked at
  /// first; 0 to begin with.
  [[nodiscard]] bool admits(std::size_t a, std::size_t b, std::size_t& last_block) const;

 private:
  /// Integrals of 1, x and y over the triangles from the origin to the edges: twice, six times, six times.
  struct Moments {
    double area = 0.0;
    double x = 0.0;
    double y = 0.0;
  };
  void place_vertices(const FlatPath& path, const PathView& view);
  void choose_places(double spacing);
  [[nodiscard]] Vec2 position(std::size_t vertex) const { return {vertices_[vertex].x, vertices_[vertex].y}; }
  [[nodiscard]] bool points_inside(std::size_t vertex, Vec2 direction) const;
  struct Edge {
    Vec2 from;
    Vec2 to;
  };
  static bool blocks(const Edge& edge, Vec2 a, Vec2 b, double clear);
  [[nodiscard]] bool is_clear(Vec2 a, Vec2 b, std::size_t& last_block) const;
  static Moments moments(Vec2 p, Vec2 q);
  static Region region(const Moments& m);

  Flattening flat_;
  std::vector<FlatVertex> vertices_;  // the last repeats the first
  std::vector<Moments> sums_;         // over the edges before each vertex
  std::vector<Edge> edges_;           // of the contour, then of the holes
  std::vector<std::size_t> places_;   // vertices
};

}  // namespace v0
}  // namespace tandem
