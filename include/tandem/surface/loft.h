#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/surface/surface.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// How the sections of a loft are spaced along v: by the distance to the next section, averaged over the
/// control points, to the power 1, 1/2 or 0.
enum class LoftParameters { chord, centripetal, uniform };

struct LoftOptions {
  /// Along v; lowered where there are too few sections for it.
  int degree = 3;
  LoftParameters parameters = LoftParameters::chord;
  /// The last section is followed by the first one: the surface is closed along v, and smooth there.
  bool closed = false;
  /// Number of control points along v: fewer than sections approximate them by least squares, first and last
  /// exactly. Empty: one per section, which interpolates. Not with `closed`.
  std::optional<int> rows = {};
  /// Approximate: the fewest rows such that no section is missed by more than this share of the size of all.
  /// Not with `rows` or `closed`.
  std::optional<double> tolerance = {};
};

/// A surface through sections, which are its curves along u.
struct Loft {
  Surface surface;
  /// v of each section, from 0 to 1; of a closed loft the last section lies before 1.
  std::vector<double> parameters;
  /// Bound on the distance of any section from the surface's curve at its v, point by point; rounding when it
  /// interpolates.
  double deviation = 0.0;
  /// Rational sections were blended over a common denominator (spec C2), so that Euclidean points are; false
  /// where that would take a degree above 25: homogeneous coordinates are then.
  bool common_denominator = true;
};

/// The surface through curves that are in step already: point by point of the same parameter. skin() brings
/// them into step first.
///
/// The sections are brought into one function space, exactly. Knots along v are averaged parameters.
/// Source: Piegl and Tiller, The NURBS Book, 9.2, 9.4 and 10.3.
/// @throws InvalidArgument fewer than two sections (closed: three), dimensions or closedness that differ,
///         neighbours that coincide, a degree outside 1 .. 25, rows outside degree + 1 .. sections, a
///         tolerance that is not > 0, or weights that change too much from section to section
[[nodiscard]] TANDEM_EXPORT Loft loft(std::span<const Curve> sections, const LoftOptions& options = {});

}  // namespace v0
}  // namespace tandem
