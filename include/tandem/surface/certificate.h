#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/curve/points.h"
#include "tandem/surface/mesh.h"
#include "tandem/surface/surface.h"
#include "tandem/tandem_export.h"

/// Proofs about surfaces as they are written out: about exactly these control points, knots and weights, not
/// about samples of them (spec B4). docs/certificates.md says how.
namespace tandem {
inline namespace v0 {

enum class Verdict {
  certified,  ///< proved
  violated,   ///< disproved: there is a witness
  undecided,  ///< neither, within the effort made
};

/// What disproves.
enum class WitnessKind {
  sign_change,  ///< the Jacobian S_u x S_v is negative at one place and positive at the other (planar)
  /// S_u x S_v is zero at the place, at a corner perhaps from one side only; of a surface that is not planar,
  /// perhaps not at it but within 1e-6 of a span.
  zero,
  crossing,   ///< two places with the same point; planar: edges of the surface that cross
  triangles,  ///< two triangles of the tessellation that have a point in common
};

/// A point of a surface.
struct SurfacePlace {
  double u = 0.0;
  double v = 0.0;
  Point point;
  double jacobian = 0.0;  ///< planar: about S_u x S_v here, of a sign that was proved; otherwise 0
};

struct Witness {
  WitnessKind kind = WitnessKind::zero;
  /// One place for `zero`, else two; of a sign change, first the one whose sign is rarer. Of `triangles` the
  /// middles, with their parameters as far as the mesh has any.
  std::vector<SurfacePlace> places;
  /// For `triangles`: which ones.
  std::array<std::size_t, 2> triangles{};
};

/// What is known of a surface.
struct Certificate {
  /// Certified if all that follow are, violated if one is.
  Verdict verdict = Verdict::undecided;
  /// The Jacobian S_u x S_v is nowhere zero: in the plane it keeps its sign, so that the surface nowhere
  /// folds over. From both sides where the surface has a crease. An edge that is one point (common end points
  /// of two rails, a pole) counts as that point and is left out.
  Verdict regular = Verdict::undecided;
  /// Planar surfaces only: no point is met twice, but for those of an edge that is one point, and those of
  /// the seam of a closed surface.
  std::optional<Verdict> one_to_one;
  /// Others, where a tessellation was given: no two of its triangles meet but in common corners and edges.
  std::optional<Verdict> tessellation_simple;
  /// What disproves, when violated.
  std::optional<Witness> witness;
};

/// Certifies the planar ruled surface (1 - v) a(u) + v b(u), v in [0,1], over the domain of both curves,
/// whose degrees, knots and weights may differ. Planar: in R^2, or in R^3 with all control points in one
/// plane: one coordinate is the same number throughout, or they lie within 1e-9 of their width of any other
/// plane. There the shadow along the axis nearest to the plane's normal is examined, and jacobians are those
/// of the shadow; what is certified holds in space. Curves that are both closed (their ends within 1e-9 of
/// the size) make a closed surface; what is certified then holds when the seam is closed exactly, too.
/// @throws InvalidArgument the dimensions or the domains differ, or the curves are not planar
[[nodiscard]] TANDEM_EXPORT Certificate certify(const Curve& a, const Curve& b);

/// Certifies a surface in R^2 or R^3, planar and closed (along either parameter) as above. In space `regular`
/// is all that is asked.
/// @throws InvalidArgument the dimension is not 2 or 3
[[nodiscard]] TANDEM_EXPORT Certificate certify(const Surface& surface);

/// And its tessellation, where the surface is not planar (simple_mesh.h).
/// @throws InvalidArgument as above, and as find_simple() of a mesh
[[nodiscard]] TANDEM_EXPORT Certificate certify(const Surface& surface, const TriangleMesh& tessellation);

}  // namespace v0
}  // namespace tandem
