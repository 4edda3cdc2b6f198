#pragma once

#include <array>
#include <memory>
#include <vector>

#include "surface/boundary.h"

namespace tandem {
inline namespace v0 {
namespace detail {

using PlaneVector = std::array<double, 2>;

/// A range of directions, narrower than a half-plane, found in plain arithmetic: a hint what to prove.
class DirectionRange {
 public:
  void add(const PlaneVector& d) noexcept;
  void add(const DirectionRange& other) noexcept;
  /// Amid the directions; zero when they fill more than a half-plane.
  [[nodiscard]] PlaneVector middle() const noexcept;

 private:
  bool empty_ = true;
  bool narrow_ = true;
  PlaneVector right_{};
  PlaneVector left_{};
};

/// A stretch of a loop: one Bezier piece, or several that follow one another. Halves are made when asked for.
class BoundaryArc {
 public:
  /// One piece of an edge over [from, to], from > to where the edge is reversed; coefficients in that order.
  BoundaryArc(const BoundaryEdge& edge, double from, double to, Enclosures coefficients);
  BoundaryArc(std::unique_ptr<BoundaryArc> first, std::unique_ptr<BoundaryArc> second);

  /// The pieces of a loop as one arc.
  [[nodiscard]] static std::unique_ptr<BoundaryArc> of_loop(const BoundaryLoop& loop);

  [[nodiscard]] bool is_piece() const noexcept { return edge_ != nullptr; }
  /// The control points of a piece.
  [[nodiscard]] const std::vector<PlanePoint>& polygon() const noexcept { return polygon_; }
  [[nodiscard]] const Enclosures& coefficients() const noexcept { return coefficients_; }
  [[nodiscard]] const BoundaryEdge* edge() const noexcept { return edge_; }
  [[nodiscard]] double from() const noexcept { return from_; }
  [[nodiscard]] double to() const noexcept { return to_; }
  [[nodiscard]] const DirectionRange& directions() const noexcept { return directions_; }
  /// Half the perimeter of the bounding box, about.
  [[nodiscard]] double size() const noexcept;

  [[nodiscard]] bool can_split() const noexcept;
  [[nodiscard]] std::array<BoundaryArc*, 2> halves();

  /// All its control polygons run forward along n, proved: n C(t) is strictly increasing (variation
  /// diminishing; also for positive weights).
  [[nodiscard]] bool runs_along(const PlaneVector& n) const;
  /// The boxes, or a line beside one of the chords, have them apart: proved.
  [[nodiscard]] bool is_apart_from(const BoundaryArc& other) const;

 private:
  void bound();

  const BoundaryEdge* edge_ = nullptr;
  double from_ = 0.0;
  double to_ = 0.0;
  Enclosures coefficients_;
  std::vector<PlanePoint> polygon_;
  PlanePoint box_;
  DirectionRange directions_;
  std::array<std::unique_ptr<BoundaryArc>, 2> halves_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
