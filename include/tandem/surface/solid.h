#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/match/match.h"
#include "tandem/surface/certificate.h"
#include "tandem/surface/mesh.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

struct SolidOptions {
  /// How contours are matched, as polylines in their planes. Directions are those of solids and holes.
  MatchOptions match = {};
  /// Largest distance of a contour from the polyline that stands for it, as a share of the size of all.
  double chord = 1e-3;
  /// Longest edge of these polylines, as a share of the contour's length.
  double longest_edge = 1.0 / 48.0;
};

/// How a solid was put together.
struct SolidReport {
  int bands = 0;     ///< between a contour, or a piece of one, and its partner on the next level
  int branches = 0;  ///< contours that were cut since they have several partners on one side
  int caps = 0;      ///< flat regions where contours end
  int left_out = 0;  ///< contours without a partner on either side: nothing comes of them
  double volume = 0.0;
  /// Of all bands, the smallest share of the length on which the two contours' matched tangents agree.
  double valid_share = 1.0;
  /// Whether no two triangles cross or touch, as find_simple() proves it. They touch where a contour branches
  /// at the level of a cap: the solid has no thickness along the chord there.
  Verdict simple = Verdict::undecided;
  std::array<std::size_t, 2> crossing{};  ///< when violated: two that do, by index
};

struct Solid {
  TriangleMesh mesh;  ///< closed, its normals point outwards; no parameters
  SolidReport report;
};

/// A closed triangle mesh through a stack of planar contours (spec C15h).
///
/// levels: at least two, in parallel planes, in order along their normal; each has one or more closed
/// contours, which may be nested (solids and holes by the even-odd rule) and do not cross.
///
/// Solids of neighbouring levels are linked where they overlap, seen along the normal (the only solid of a
/// level with the only one of the next in any case), and holes likewise where their solids are linked. A
/// contour that is linked with several is cut between them by cut_contour(): the pieces share straight
/// chords, on which the surface folds at that level. Links by which two contours would both have several
/// partners and one another are given up, least overlap first. What has no partner on one
/// side ends in a flat cap.
///
/// The mesh is closed and consistently oriented by construction: every contour is one polyline for all that
/// meets there. Whether two of its triangles cross is checked, not prevented: report.simple.
/// @throws InvalidArgument fewer than two levels, one without contours, an open contour, one that is not in
///         R^3 or not in a plane, planes that are not parallel or not in order, a contour without area,
///         options out of
///         range, or no links at all
[[nodiscard]] TANDEM_EXPORT Solid contours_to_solid(std::span<const std::vector<Curve>> levels,
                                                    const SolidOptions& options = {});

}  // namespace v0
}  // namespace tandem
