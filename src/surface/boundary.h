#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "surface/enclosed_spline.h"
#include "tandem/surface/certificate.h"
#include "tandem/surface/surface.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A point of the plane of which enclosures of the coordinates are known.
using PlanePoint = std::array<Enclosure, 2>;

/// An edge of a planar surface: of both parameters the one moves, along the spline's domain, and the other is
/// fixed.
struct BoundaryEdge {
  EnclosedSpline spline;  ///< two coordinates and, if rational, the weight
  bool rational = false;
  bool reversed = false;  ///< run through backwards in its loop
  Along along = Along::u;
  double fixed = 0.0;

  /// The control points of a part within one span, in the direction of the spline.
  [[nodiscard]] Enclosures coefficients(Interval part) const { return spline.bezier(part); }
  /// Of all parts of [part.lo, part.hi], which may go over knots.
  [[nodiscard]] std::vector<PlanePoint> polygon(Interval part) const;
};

/// Edges one after the other, each beginning where the one before it ends, and the first where the last ends.
using BoundaryLoop = std::vector<BoundaryEdge>;

/// Divides by the weights.
[[nodiscard]] std::vector<PlanePoint> plane_points(const Enclosures& coefficients, bool rational);

struct BoundaryPlace {
  const BoundaryEdge* edge = nullptr;
  double t = 0.0;
};

struct SimpleBoundary {
  Verdict verdict = Verdict::undecided;
  /// When violated: two places of the boundary with the same point.
  std::array<BoundaryPlace, 2> places{};
};

/// Whether the loops are simple closed curves, disjoint from each other. Proof: an arc whose control polygon
/// runs forward in some direction is injective, and two such arcs that are consecutive have only their joint
/// in common; other arcs are disjoint if a line separates their control polygons. Arcs are halved until one
/// or the other is so. Disproof: two short arcs that cross like a road and a river (see cross() in
/// boundary.cpp).
[[nodiscard]] SimpleBoundary find_simple(const std::vector<BoundaryLoop>& loops);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
